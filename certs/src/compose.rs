//! C5: two certificates on one shell and one vertex order together prove a homeomorphism from A to B (FORMAT section 7).
//! Nothing geometric is decided here: each certificate is checked by itself.

use crate::parse::{Cert, parse};
use crate::{Fail, Res};
use std::borrow::Cow;

/// Checks both certificates, then that they fit together.
pub(crate) fn run(certs: [&[u8]; 2], shell: &[u8], meshes: [&[u8]; 2]) -> Res<Vec<(&'static str, bool)>> {
    let check = |i: usize| {
        let inputs = [shell.to_vec(), meshes[i].to_vec()];
        let cert = parse(certs[i])?;
        crate::run(certs[i], || Ok(Cow::Borrowed(&inputs[..])))?;
        Ok(cert)
    };
    let named = |i: usize| {
        check(i).map_err(|f: Fail| Fail { message: format!("{}: {}", ["A", "B"][i], f.message), ..f })
    };
    fits(&named(0)?, &named(1)?)?;
    Ok(vec![("composition", true)])
}

fn fits(a: &Cert, b: &Cert) -> Res {
    ensure!(a.shell.sha == b.shell.sha, "shells", "the certificates are about different shells");
    ensure!(a.order == b.order, "orders", "the certificates are about different vertex orders");
    for (name, cert) in [("A", a), ("B", b)] {
        ensure!(
            cert.claims.contains(&("bijection", true)),
            "not-certified",
            "{name}: `bijection` is not certified"
        );
    }
    Ok(())
}
