//! Planes that separate, points that two sets share.

use std::collections::BTreeSet;

use dashu_int::IBig;

use super::places::Places;
use super::text::{Lines, names, number, value, weights};
use super::{Flaw, Judge, Judged, Ordered, holds, sorted};
use crate::oracle::exact::{Point, Weights, cross, dot, minus, orient, positive};
use crate::oracle::tets::Code;

pub(super) fn judge(
    judge: &Judge<'_>,
    name: &str,
    certified: bool,
    lines: &[Vec<&str>],
    before: Option<&Lines<'_>>,
    ordered: &Ordered,
) -> Judged {
    if certified {
        let keys = |lines: &[Vec<&str>]| -> BTreeSet<String> {
            let key = |l: &Vec<&str>| -> String {
                let words: Vec<&str> = l.iter().skip(1).take_while(|w| !w.contains(':')).copied().collect();
                words.join(" ")
            };
            lines.iter().map(key).collect()
        };
        lines.iter().try_for_each(|line| separation(judge, name, line, ordered))?;
        // Which pairs need planes follows from the input alone.
        let missing = before.is_some_and(|b| !keys(b).is_subset(&keys(lines)));
        return holds(!missing, "a pair is left out");
    }
    holds(!lines.is_empty(), "no fact")?;
    if let ("disjoint-prisms", [line]) = (name, lines)
        && line[0] == "tet"
    {
        return judge.bad_tet(line, &ordered.selected);
    }
    lines.iter().try_for_each(|line| contact(judge, name, line, ordered))
}

/// The triangles of the skin, by names: faces of one tet only.
fn skin(judge: &Judge<'_>, ordered: &Ordered) -> Vec<Vec<Code>> {
    let mut all: Vec<Vec<Code>> = Vec::new();
    for &t in &ordered.selected {
        let tet = sorted(judge.world.tets.all[t].names);
        all.extend(
            (0..4).map(|k| tet.iter().copied().enumerate().filter(|x| x.0 != k).map(|x| x.1).collect()),
        );
    }
    all.sort();
    let once = |face: &&Vec<Code>| all.iter().filter(|f| f == face).count() == 1;
    all.iter().filter(once).cloned().collect()
}

/// The two point sets of a `sep` line, and what may remain.
struct Two<'a> {
    sets: [Vec<&'a Point>; 2],
    normal: Point,
    /// Places in the sets of what they share.
    common: Option<[BTreeSet<usize>; 2]>,
    pinches: Vec<&'a Point>,
}

fn normal(corners: &[&Point]) -> Point {
    cross(&minus(corners[1], corners[0]), &minus(corners[2], corners[0]))
}

fn common<T: PartialEq>(a: &[T], b: &[T]) -> [BTreeSet<usize>; 2] {
    let places = |a: &[T], b: &[T]| (0..a.len()).filter(|&i| b.contains(&a[i])).collect();
    [places(a, b), places(b, a)]
}

fn two<'a>(judge: &'a Judge<'_>, name: &str, line: &[&str], ordered: &Ordered) -> Result<Two<'a>, Flaw> {
    let world = &judge.world;
    let (i, j): (usize, usize) = (number(line[1])?, number(line[2])?);
    let pinched = |codes: &[Code]| {
        codes.iter().filter(|c| world.pinched[(*c / 3) as usize]).map(|c| world.at(*c)).collect()
    };
    if name == "disjoint-prisms" {
        let skin = skin(judge, ordered);
        let (Some(a), Some(b)) = (skin.get(i), skin.get(j)) else {
            return Err(Flaw::False("no such triangle of the skin"));
        };
        let at = |names: &[Code]| names.iter().map(|&c| world.at(c)).collect::<Vec<_>>();
        let (first, second) = (at(a), at(b));
        let normal = normal(&first);
        return Ok(Two { sets: [first, second], normal, common: Some(common(a, b)), pinches: Vec::new() });
    }
    let face = *world.mesh.faces.get(i).ok_or(Flaw::Unreadable)?;
    let first = world.triangle(i).to_vec();
    let normal = normal(&first);
    if name == "disjoint-mesh" {
        let other = *world.mesh.faces.get(j).ok_or(Flaw::Unreadable)?;
        let second = world.triangle(j).to_vec();
        return Ok(Two {
            sets: [first, second],
            normal,
            common: Some(common(&face, &other)),
            pinches: Vec::new(),
        });
    }
    let prism = *world.shell.faces.get(j).ok_or(Flaw::Unreadable)?;
    let codes = match name {
        "disjoint-bottom" => prism.map(|v| 3 * v).to_vec(),
        "disjoint-top" => prism.map(|v| 3 * v + 2).to_vec(),
        _ => {
            let all: Vec<usize> = (0..world.tets.all.len()).collect();
            let tet = judge.tet(line.get(3).ok_or(Flaw::Unreadable)?, &all, Some(j))?;
            world.tets.all[tet].names.to_vec()
        }
    };
    let second = codes.iter().map(|&c| world.at(c)).collect();
    Ok(Two { sets: [first, second], normal, common: None, pinches: pinched(&codes) })
}

/// Are the planes of the line such that the two sets can share nothing but what they may?
fn separation(judge: &Judge<'_>, name: &str, line: &[&str], ordered: &Ordered) -> Judged {
    let start = if name == "i2" { 4 } else { 3 };
    if line.len() <= start {
        return Err(Flaw::Unreadable);
    }
    let two = two(judge, name, line, ordered)?;
    let mut rest: [Vec<usize>; 2] = [0, 1].map(|s| (0..two.sets[s].len()).collect());
    for plane in &line[start..] {
        let values = plane_values(judge, plane, &two)?;
        let sign = |s: usize, i: usize| values[s][i].cmp(&IBig::ZERO) as i8;
        let sides = |turn: i8| {
            rest[0].iter().all(|&i| sign(0, i) * turn >= 0) && rest[1].iter().all(|&i| sign(1, i) * turn <= 0)
        };
        holds(sides(1) || sides(-1), "a plane with both sets on one side")?;
        let on = |s: usize| rest[s].iter().copied().filter(|&i| sign(s, i) == 0).collect();
        rest = [on(0), on(1)];
    }
    let harmless = |s: usize| match &two.common {
        Some(common) => rest[s].iter().copied().collect::<BTreeSet<_>>() == common[s],
        None => match rest[s][..] {
            [] => true,
            [i] => two.pinches.contains(&two.sets[s][i]),
            _ => false,
        },
    };
    holds(harmless(0) || harmless(1), "planes that leave something")
}

/// The value of a plane at every point of both sets.
fn plane_values(judge: &Judge<'_>, plane: &str, two: &Two<'_>) -> Result<[Vec<IBig>; 2], Flaw> {
    let (kind, points) = plane.split_once(':').ok_or(Flaw::Unreadable)?;
    let points: Vec<&Point> = points.split(',').map(|p| place(judge, p)).collect::<Result<_, _>>()?;
    let value = |x: &Point| match (kind, &points[..]) {
        ("p", [a, b, c]) => Ok(orient(a, b, c, x)),
        ("l", [a, b]) => Ok(dot(&cross(&minus(b, a), &two.normal), &minus(x, a))),
        ("n", [a, b]) => Ok(dot(&minus(b, a), &minus(x, a))),
        _ => Err(Flaw::Unreadable),
    };
    let of = |s: usize| two.sets[s].iter().map(|x| value(x)).collect::<Result<Vec<_>, _>>();
    Ok([of(0)?, of(1)?])
}

/// `b3`, `m3`, `t3` or `g3`.
fn place<'a>(judge: &'a Judge<'_>, word: &str) -> Result<&'a Point, Flaw> {
    let world = &judge.world;
    if let Some(id) = word.strip_prefix('g') {
        return world.points.get(number::<usize>(id)?).ok_or(Flaw::Unreadable);
    }
    let code = names(word)?[0];
    let pinched = *world.pinched.get((code / 3) as usize).ok_or(Flaw::Unreadable)?;
    holds(code % 3 == 1 || !pinched, "a name that does not exist")?;
    Ok(world.at(code))
}

/// `cross`, `contact`, `overlap`: one point in two sets, and not the one that they may share.
fn contact(judge: &Judge<'_>, name: &str, line: &[&str], ordered: &Ordered) -> Judged {
    let world = &judge.world;
    if name == "disjoint-prisms" {
        let [_, s, ref rest @ ..] = line[..] else { return Err(Flaw::Unreadable) };
        let [a0, a1, a2, a3, t, ref of_t @ ..] = rest[..] else { return Err(Flaw::Unreadable) };
        let (first, second) =
            (judge.tet(s, &ordered.selected, None)?, judge.tet(t, &ordered.selected, None)?);
        let codes = [first, second].map(|t| sorted(world.tets.all[t].names));
        let both = [weights(&[a0, a1, a2, a3])?, weights(of_t)?];
        let used = shared(&codes.each_ref().map(|c| c.iter().map(|&n| world.at(n)).collect()), &both)?;
        let names = |s: usize| used[s].iter().map(|&i| codes[s][i]).collect::<Vec<_>>();
        return holds(names(0) != names(1), "one point of both tets");
    }
    if line.len() < 9 {
        return Err(Flaw::Unreadable);
    }
    let (i, j): (usize, usize) = (number(line[1])?, number(line[2])?);
    let face = *world.mesh.faces.get(i).ok_or(Flaw::Unreadable)?;
    let first = world.triangle(i).to_vec();
    if name == "disjoint-mesh" {
        let other = *world.mesh.faces.get(j).ok_or(Flaw::Unreadable)?;
        let both = [weights(&line[3..6])?, weights(&line[6..])?];
        let used = shared(&[first, world.triangle(j).to_vec()], &both)?;
        let of = |s: usize, f: [u32; 3]| used[s].iter().map(|&k| f[k]).collect::<BTreeSet<_>>();
        return holds(of(0, face) != of(1, other), "one point of the mesh");
    }
    let prism = *world.shell.faces.get(j).ok_or(Flaw::Unreadable)?;
    let (codes, both): (Vec<Code>, [Weights; 2]) = if name == "i2" {
        if line.len() != 12 {
            return Err(Flaw::Unreadable);
        }
        let all: Vec<usize> = (0..world.tets.all.len()).collect();
        let t = judge.tet(line[3], &all, Some(j))?;
        let slope = world.slope(i, t);
        let unit = &judge.unit * &judge.unit * &judge.unit;
        let stated = value(line[11])? * unit;
        holds(dashu_ratio::RBig::from(slope.clone()) == stated, "another dot")?;
        holds(!positive(&slope), "a positive dot")?;
        (sorted(world.tets.all[t].names), [weights(&line[4..7])?, weights(&line[7..11])?])
    } else {
        let layer = if name == "disjoint-bottom" { 0 } else { 2 };
        let code = |v: u32| if world.pinched[v as usize] { 3 * v + 1 } else { 3 * v + layer };
        (prism.map(code).to_vec(), [weights(&line[3..6])?, weights(&line[6..])?])
    };
    let used = shared(&[first, codes.iter().map(|&c| world.at(c)).collect()], &both)?;
    let alone = matches!(used[1][..], [k] if world.pinched[(codes[k] / 3) as usize]);
    holds(!alone, "a pinched vertex")
}

/// The corners with positive weight in both sets, if the two weighted points are equal.
fn shared(sets: &[Vec<&Point>; 2], weights: &[Weights; 2]) -> Result<[Vec<usize>; 2], Flaw> {
    if (0..2).any(|s| sets[s].len() != weights[s].len()) {
        return Err(Flaw::Unreadable);
    }
    let [a, b] = [0, 1].map(|s| Places::mixed(&sets[s], &weights[s]));
    holds(a == b, "two different points")?;
    Ok([0, 1].map(|s| (0..sets[s].len()).filter(|&i| positive(&weights[s][i])).collect()))
}
