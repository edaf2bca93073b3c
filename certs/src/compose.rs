//! C5: two certificates on one shell and one vertex order together prove a homeomorphism from A to B (FORMAT section 7).
//! Nothing geometric is decided here: each certificate is checked by itself.

use crate::{Checked, Fail, Res};

/// The message of an error begins with the certificate's name.
pub(crate) fn named(name: &str, result: Res<Checked>) -> Res<Checked> {
    result.map_err(|f: Fail| Fail { message: format!("{name}: {}", f.message), ..f })
}

/// Do certificates that were checked fit together?
pub(crate) fn fits(a: &Checked, b: &Checked) -> Res<Vec<(&'static str, bool)>> {
    ensure!(a.shell == b.shell, "shells", "the certificates are about different shells");
    ensure!(a.order == b.order, "orders", "the certificates are about different vertex orders");
    for (name, cert) in [("A", a), ("B", b)] {
        ensure!(
            cert.claims.contains(&("bijection", true)),
            "not-certified",
            "{name}: `bijection` is not certified"
        );
    }
    Ok(vec![("composition", true)])
}
