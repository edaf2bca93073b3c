//! The lines of a witness (MESHES section 4.5). None needs a sound input.

use super::cells::{reverse, turned};
use super::claims::{Input, centroid, winding};
use super::parse::{Cert, Fact, Ray, What};
use super::points::Points;
use super::rays;
use crate::Res;
use crate::complex::distinct;
use crate::separate::carrier;

pub(super) fn check(cert: &Cert, inputs: &[Input], points: &Points) -> Res {
    for fact in &cert.witness {
        let holds = holds(fact, inputs, points)?;
        ensure!(holds, "not-refuted", "line {}", fact.line);
    }
    Ok(())
}

fn holds(fact: &Fact, inputs: &[Input], points: &Points) -> Res<bool> {
    let input = &inputs[fact.input];
    let cells = &input.cells;
    let set = |c: usize| distinct(cells.cell(c).iter().copied());
    let sign = |c: usize| input.sign(points, c);
    Ok(match &fact.what {
        What::Repeated(c) => set(*c).len() < cells.k,
        What::Flat(c) => sign(*c) == 0,
        What::Twin([c, d]) => set(*c) == set(*d),
        What::Direction([c, d]) => {
            let ways = |c: usize| cells.facets(c).map(|f| turned(cells.facet(f))).collect::<Vec<_>>();
            let other = ways(*d);
            ways(*c).iter().any(|way| other.contains(way))
        }
        What::Facet(ids, three) => three.iter().all(|&c| cells.has(c, ids)),
        What::Around(ids, both) => {
            let star: Vec<usize> = cells.with(ids).collect();
            let classes = cells.around(&star, ids);
            match both.map(|c| star.binary_search(&c)) {
                [Ok(c), Ok(d)] => classes[c] != classes[d],
                _ => false,
            }
        }
        What::Link(v) => {
            let star: Vec<usize> = cells.with(&[*v]).collect();
            !star.is_empty() && !cells.round_link(*v, &star)
        }
        What::Open([u, v]) => {
            let way = [*u, *v, super::cells::NONE];
            let exists = |way| (0..cells.corners.len()).any(|f| cells.facet(f) == way);
            exists(way) && !exists(reverse(way))
        }
        What::Sign([c, d]) => {
            let parts = cells.components();
            parts[*c] == parts[*d] && sign(*c) * sign(*d) <= 0
        }
        What::Twice { facet, cell } => {
            let lacks =
                cells.facet(*facet).iter().any(|&v| v != super::cells::NONE && !cells.has(*cell, &[v]));
            lacks && points.holds(&input.points(cells.cell(*cell)), &centroid(input, *facet, points))
        }
        What::Cross([x, y], [i, j], [first, second]) => {
            let ids =
                [inputs[*x].points(inputs[*x].cells.cell(*i)), inputs[*y].points(inputs[*y].cells.cell(*j))];
            let equal = points.mean(&ids[0], first) == points.mean(&ids[1], second);
            ensure!(equal, "wrong-point", "line {}", fact.line);
            carrier(&ids[0], first) != carrier(&ids[1], second)
        }
        What::Winding(ray) => winds_wrong(ray, inputs, points)?,
    })
}

fn winds_wrong(ray: &Ray, inputs: &[Input], points: &Points) -> Res<bool> {
    let (input, other) = (&inputs[ray.input], &inputs[1 - ray.input]);
    other.not_flat(points)?;
    let used = input.cells.corners.contains(&ray.vertex);
    ensure!(used, "ray-component", "line {}: an unused vertex", ray.line);
    let faces = other.triangles();
    let number = rays::number(points, input.base + ray.vertex, ray, &faces, &faces.tree(points))?;
    Ok(number != winding(ray.input))
}
