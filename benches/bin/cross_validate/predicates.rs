//! Predicates: homeo's answers against those of EPICK and EPECK.

use homeo::predicate::{
    Axis, Meeting, Sign, dot_sign, incircle, insphere, orient2d, orient3d, point_in_tet, ray_triangle,
    same_point, segment_triangle, triangle_tet, triangle_triangle, zero_area,
};
use homeo::shell::decomposition::TETS;
use homeo_benches::cgal::{Cgal, CgalError};
use homeo_benches::random::Random;
use homeo_benches::subject::Subject;
use homeo_benches::table::Table;

use crate::cases::{Generator, Kind};
use crate::findings::{Findings, line};

/// Cases that are sent at once.
const BATCH: usize = 4096;
/// Cases of each predicate that go through text mode, too.
const IN_TEXT: usize = 240;

type Points<'a> = &'a [[f64; 3]];

/// A predicate of `docs/SUBJECTS.md`.
struct Predicate {
    name: &'static str,
    points: usize,
    dimension: usize,
    /// homeo's answer.
    ours: fn(Points<'_>) -> i8,
    /// The triangles (first corner) that must have area; with `segment`, points 0 and 1 must differ.
    triangles: &'static [usize],
    segment: bool,
    /// Points 3 to 6 are a tet that must have volume.
    tet: bool,
}

/// What most of them have. Its answer is none, so a predicate that keeps it disagrees with every program.
const PLAIN: Predicate = Predicate {
    name: "",
    points: 0,
    dimension: 3,
    ours: |_| ours::NONE,
    triangles: &[],
    segment: false,
    tet: false,
};

const PREDICATES: [Predicate; 12] = [
    Predicate { name: "orient2d", points: 3, dimension: 2, ours: ours::orient2d, ..PLAIN },
    Predicate { name: "orient3d", points: 4, ours: ours::orient3d, ..PLAIN },
    Predicate { name: "dot_sign", points: 5, ours: ours::dot, ..PLAIN },
    Predicate { name: "point_in_tet", points: 5, ours: ours::in_tet, ..PLAIN },
    Predicate { name: "triangle_triangle", points: 6, ours: ours::triangles, triangles: &[0, 3], ..PLAIN },
    Predicate {
        name: "segment_triangle",
        points: 5,
        ours: ours::segment,
        triangles: &[2],
        segment: true,
        ..PLAIN
    },
    Predicate { name: "triangle_tet", points: 7, ours: ours::tet, triangles: &[0], tet: true, ..PLAIN },
    Predicate { name: "prism_positivity", points: 6, ours: ours::prism, ..PLAIN },
    Predicate { name: "section_dot", points: 9, ours: ours::section, ..PLAIN },
    Predicate { name: "incircle", points: 4, dimension: 2, ours: ours::circle, ..PLAIN },
    Predicate { name: "insphere", points: 5, ours: ours::sphere, ..PLAIN },
    Predicate { name: "ray_triangle", points: 5, ours: ours::ray, triangles: &[2], segment: true, ..PLAIN },
];

/// homeo's predicates in the order of points of `docs/SUBJECTS.md`. A slice of another length gives 2: no answer.
mod ours {
    use super::*;

    pub(super) const NONE: i8 = 2;

    fn met(meeting: Meeting) -> i8 {
        i8::from(meeting.meets())
    }

    pub(super) fn orient2d(p: Points<'_>) -> i8 {
        let [a, b, c] = p else { return NONE };
        super::orient2d(a, b, c, Axis::Z).as_i8()
    }

    pub(super) fn orient3d(p: Points<'_>) -> i8 {
        let [a, b, c, d] = p else { return NONE };
        super::orient3d(a, b, c, d).as_i8()
    }

    pub(super) fn dot(p: Points<'_>) -> i8 {
        let [a, b, c, s, t] = p else { return NONE };
        dot_sign(a, b, c, s, t).as_i8()
    }

    pub(super) fn circle(p: Points<'_>) -> i8 {
        let [a, b, c, d] = p else { return NONE };
        let [a, b, c, d] = [a, b, c, d].map(|[x, y, _]| [*x, *y]);
        incircle(&a, &b, &c, &d).as_i8()
    }

    pub(super) fn sphere(p: Points<'_>) -> i8 {
        let [a, b, c, d, e] = p else { return NONE };
        insphere(a, b, c, d, e).as_i8()
    }

    pub(super) fn ray(p: Points<'_>) -> i8 {
        let [o, q, a, b, c] = p else { return NONE };
        i8::from(ray_triangle([o, q], [a, b, c]))
    }

    pub(super) fn in_tet(p: Points<'_>) -> i8 {
        let [a, b, c, d, x] = p else { return NONE };
        point_in_tet(x, [a, b, c, d]).map_or(-1, |mask| i8::from(mask.is_interior()))
    }

    pub(super) fn triangles(p: Points<'_>) -> i8 {
        let [a, b, c, d, e, f] = p else { return NONE };
        met(triangle_triangle([a, b, c], [d, e, f]))
    }

    pub(super) fn segment(p: Points<'_>) -> i8 {
        let [s, t, a, b, c] = p else { return NONE };
        met(segment_triangle([s, t], [a, b, c]))
    }

    pub(super) fn tet(p: Points<'_>) -> i8 {
        let [a, b, c, d, e, f, g] = p else { return NONE };
        met(triangle_tet([a, b, c], [d, e, f, g]))
    }

    fn least(signs: impl Iterator<Item = Sign>) -> i8 {
        signs.map(Sign::as_i8).min().unwrap_or(NONE)
    }

    pub(super) fn prism(p: Points<'_>) -> i8 {
        let [a, b, c, d, e, f] = p else { return NONE };
        let layers = [[a, b, c], [d, e, f]];
        least(TETS.iter().map(|tet| {
            let corners = tet.vertices.map(|(corner, hi)| layers[usize::from(hi)][usize::from(corner)]);
            let [a, b, c, d] = corners;
            super::orient3d(a, b, c, d)
        }))
    }

    pub(super) fn section(p: Points<'_>) -> i8 {
        let [a, b, c, low @ .., _, _, _] = p else { return NONE };
        let Some(high) = p.get(6..) else { return NONE };
        least(low.iter().zip(high).map(|(l, h)| dot_sign(a, b, c, l, h)))
    }
}

impl Predicate {
    fn arity(&self) -> usize {
        self.points * self.dimension
    }

    fn points_of(&self, numbers: &[f64]) -> Vec<[f64; 3]> {
        let point = |x: &[f64]| [0, 1, 2].map(|i| x.get(i).copied().unwrap_or(0.0));
        numbers.chunks(self.dimension).map(point).collect()
    }

    /// Is it one of the cases that the protocol allows?
    fn allows(&self, points: Points<'_>) -> bool {
        let area = |&first: &usize| match points.get(first..first + 3) {
            Some([a, b, c]) => !zero_area(a, b, c),
            _ => false,
        };
        let volume = || match points.get(3..7) {
            Some([a, b, c, d]) => !orient3d(a, b, c, d).is_zero(),
            _ => false,
        };
        let length = || matches!(points, [a, b, ..] if !same_point(a, b));
        self.triangles.iter().all(area) && (!self.tet || volume()) && (!self.segment || length())
    }

    /// An allowed case of this kind, or a uniform one where the kind gives hardly any.
    fn case(&self, kind: Kind, generator: &mut Generator) -> (Vec<f64>, Vec<[f64; 3]>) {
        for attempt in 0.. {
            let kind = if attempt < 50 { kind } else { Kind::Uniform };
            let numbers = generator.case(kind, self.points, self.dimension);
            let points = self.points_of(&numbers);
            if self.allows(&points) {
                return (numbers, points);
            }
        }
        Default::default()
    }
}

/// The programs.
struct Subjects {
    epick: Subject,
    epeck: Subject,
    /// Plain doubles: gets the first batch of each predicate, to show that the cases tell right from wrong.
    control: Subject,
}

/// Cases compared with EPICK, with EPECK; the answers -1, 0, 1; wrong answers of the control; disagreements.
type Counts = [usize; 7];

/// Compares `cases` cases in all with EPICK, and `exact` of them with EPECK; prints the table.
pub(crate) fn run(
    cgal: &Cgal,
    cases: usize,
    exact: usize,
    seed: u64,
    findings: &mut Findings,
) -> Result<(), CgalError> {
    let mut subjects = Subjects {
        epick: Subject::start(&cgal.0, "subject_epick", &[])?,
        epeck: Subject::start(&cgal.0, "subject_epeck", &[])?,
        control: Subject::start(&cgal.0, "subject_double", &[])?,
    };
    let header =
        ["predicate", "homeo and EPICK", "homeo and EPECK", "-1", "0", "1", "doubles wrong", "disagree"];
    let mut table = Table::new(&header);
    let mut sums = Counts::default();
    for (salt, predicate) in (0..).zip(&PREDICATES) {
        let share = (cases.div_ceil(PREDICATES.len()), exact.div_ceil(PREDICATES.len()));
        let before = findings.count();
        let mut generator = Generator(Random(seed.wrapping_add(salt << 40)));
        let mut counts = predicate.compare(&mut subjects, share, &mut generator, findings)?;
        counts[6] = usize::try_from(findings.count() - before).unwrap_or(usize::MAX);
        let mut row = vec![predicate.name.to_owned()];
        row.extend(counts.iter().map(ToString::to_string));
        sums.iter_mut().zip(&counts).for_each(|(sum, n)| *sum += n);
        table.row(row);
    }
    let mut row = vec!["all".to_owned()];
    row.extend(sums.iter().map(ToString::to_string));
    table.row(row);
    print!("{}", table.render());
    if sums[5] == 0 && sums[0] > 0 {
        findings.add("the cases are too easy: plain doubles answer all of them correctly");
    }
    Ok(())
}

impl Predicate {
    /// All counts but the disagreements.
    fn compare(
        &self,
        subjects: &mut Subjects,
        (cases, exact): (usize, usize),
        generator: &mut Generator,
        findings: &mut Findings,
    ) -> Result<Counts, CgalError> {
        let total = cases.max(exact);
        let mut counts = Counts::default();
        while counts[0] < total {
            let n = BATCH.min(total - counts[0]);
            // As large a part of every batch as of the whole.
            let m = (exact * (counts[0] + n)).div_ceil(total.max(1)).saturating_sub(counts[1]).min(n);
            let batch: Vec<(Vec<f64>, Vec<[f64; 3]>)> =
                (0..n).map(|i| self.case(Kind::ALL[i % Kind::ALL.len()], generator)).collect();
            let numbers: Vec<f64> = batch.iter().flat_map(|(numbers, _)| numbers.iter().copied()).collect();
            subjects.epick.send(self.name, n, &numbers)?;
            if m > 0 {
                subjects.epeck.send(self.name, m, &numbers[..m * self.arity()])?;
            }
            let ours: Vec<i8> = batch.iter().map(|(_, points)| (self.ours)(points)).collect();
            let epick = subjects.epick.signs(n)?;
            let epeck = if m > 0 { subjects.epeck.signs(m)? } else { Vec::new() };
            for (i, (numbers, _)) in batch.iter().enumerate() {
                let theirs = [Some(epick[i]), epeck.get(i).copied()];
                let mine = ours[i];
                // Two that have no answer do not agree.
                let is_answer = (-1..=1).contains(&mine);
                if !is_answer || theirs.into_iter().flatten().any(|answer| answer != mine) {
                    let kind = Kind::ALL[i % Kind::ALL.len()];
                    findings.add(&format!(
                        "{kind:?}: homeo {mine}, EPICK {:?}, EPECK {:?}: {}",
                        theirs[0],
                        theirs[1],
                        line(self.name, numbers)
                    ));
                }
                if let Ok(answer @ 0..=2) = usize::try_from(mine + 1) {
                    counts[2 + answer] += 1;
                }
            }
            if counts[0] == 0 {
                self.in_text(&batch, &epick, &mut subjects.epick, findings)?;
                counts[5] = self.wrong(&numbers, &epick, &mut subjects.control)?;
            }
            counts[0] += n;
            counts[1] += m;
        }
        Ok(counts)
    }

    /// How often the control is wrong. Intersections with wrong signs inside are beyond what CGAL's code is made for.
    fn wrong(&self, numbers: &[f64], right: &[i8], control: &mut Subject) -> Result<usize, CgalError> {
        if !self.triangles.is_empty() {
            return Ok(0);
        }
        control.send(self.name, right.len(), numbers)?;
        let answers = control.signs(right.len())?;
        Ok(answers.iter().zip(right).filter(|(a, b)| a != b).count())
    }

    /// The program answers the same in text mode.
    fn in_text(
        &self,
        batch: &[(Vec<f64>, Vec<[f64; 3]>)],
        binary: &[i8],
        subject: &mut Subject,
        findings: &mut Findings,
    ) -> Result<(), CgalError> {
        for ((numbers, _), sign) in batch.iter().zip(binary).take(IN_TEXT) {
            let case = line(self.name, numbers);
            subject.send_line(&case)?;
            let answer = subject.line()?;
            if answer != sign.to_string() {
                findings.add(&format!("{}: {sign} in binary, {answer} in text mode: {case}", subject.name()));
            }
        }
        Ok(())
    }
}
