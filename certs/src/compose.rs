//! C5: two certificates on one shell and one vertex order together prove a homeomorphism from A to B (FORMAT section 7).
//! Nothing geometric is decided here: each certificate is checked by itself.

use crate::parse::{Cert, parse};
use crate::{Fail, Res};
use std::borrow::Cow;

/// Checks a certificate by itself; the message of an error begins with its name.
pub(crate) fn checked<'a>(
    name: &str,
    cert: Res<Cow<'a, [u8]>>,
    inputs: impl FnOnce() -> Res<Cow<'a, [Vec<u8>]>>,
) -> Res<Cert> {
    let check = || {
        let bytes = cert?;
        let cert = parse(&bytes)?;
        crate::run(&bytes, inputs)?;
        Ok(cert)
    };
    check().map_err(|f: Fail| Fail { message: format!("{name}: {}", f.message), ..f })
}

/// Do certificates that were checked fit together?
pub(crate) fn fits(a: &Cert, b: &Cert) -> Res<Vec<(&'static str, bool)>> {
    ensure!(a.shell.sha == b.shell.sha, "shells", "the certificates are about different shells");
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
