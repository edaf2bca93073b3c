//! One change of a certificate's text, of the kinds that a fault of the certifier could make; counts stay right unless
//! they are what is changed.

use crate::meshes::Random;

type Line = Vec<String>;

/// Kinds of changes.
pub const KINDS: [&str; 15] = [
    "verdict", "hash", "size", "counts", "order", "id", "layer", "like", "plane", "sign", "drop", "double",
    "swap", "word", "foreign",
];

fn words(text: &str) -> Vec<Line> {
    text.lines().map(|l| l.split(' ').map(str::to_owned).collect()).collect()
}

/// The fact lines of a text: lines that a `foreign` change may take.
#[must_use]
pub fn facts(text: &str) -> Vec<String> {
    let lines = words(text);
    fact_places(&lines).into_iter().map(|i| lines[i].join(" ")).collect()
}

fn fact_places(lines: &[Line]) -> Vec<usize> {
    let first = lines.iter().position(|l| l[0] == "begin").unwrap_or(lines.len());
    let last = lines.iter().position(|l| l[0] == "counts").unwrap_or(lines.len());
    (first..last.max(first)).filter(|&i| lines[i][0] != "begin").collect()
}

/// The kind and the changed text, or `None` where this kind has nothing to change.
pub fn change(honest: &str, foreign: &[String], random: &mut Random) -> Option<(&'static str, String)> {
    // Most facts are ids and names.
    let kind = KINDS[[0, 1, 2, 3, 4, 5, 5, 5, 6, 6, 7, 7, 8, 8, 9, 10, 11, 12, 13, 14][random.below(20)]];
    let mut lines = words(honest);
    let places = |word: &str| (0..lines.len()).filter(|&i| lines[i][0] == word).collect::<Vec<_>>();
    match kind {
        "verdict" => {
            let claims = places("claim");
            let at = claims[random.below(claims.len())];
            // These two have one verdict: otherwise the text is refused without a look at what it says.
            let both = ["section", "bijection"];
            let pair = both.contains(&lines[at][1].as_str()) && random.below(4) > 0;
            let names: Vec<String> = lines.iter().map(|l| l.get(1).cloned().unwrap_or_default()).collect();
            let too = |i: usize| i == at || (pair && both.contains(&names[i].as_str()));
            for i in claims.into_iter().filter(|&i| too(i)) {
                lines[i][2] = if lines[i][2] == "refuted" { "certified" } else { "refuted" }.to_owned();
            }
        }
        "hash" => {
            let at = some(&[places("shell"), places("mesh")].concat(), random)?;
            let k = random.below(64);
            let old = lines[at][1].as_bytes()[k];
            let digits: Vec<u8> = b"0123456789abcdef".iter().copied().filter(|d| *d != old).collect();
            let new = char::from(digits[random.below(15)]).to_string();
            lines[at][1].replace_range(k..=k, &new);
        }
        "size" => {
            let at = some(&[places("shell"), places("mesh"), places("pinched")].concat(), random)?;
            let start = if lines[at][0] == "pinched" { 1 } else { 2 };
            let k = start + random.below(lines[at].len() - start);
            renumber(&mut lines[at][k], random)?;
        }
        "counts" => {
            let at = places("counts")[0];
            if lines[at].len() == 1 {
                return None;
            }
            let k = 1 + random.below(lines[at].len() - 1);
            renumber(&mut lines[at][k], random)?;
            return Some((kind, write(&lines)));
        }
        "order" => reorder(&mut lines, random)?,
        _ => {
            let places = fact_places(&lines);
            // Many words have no sign, no layer, no plane: another try.
            lines = (0..30).find_map(|_| {
                let mut changed = lines.clone();
                let at = some(&places, random)?;
                fact(kind, &mut changed, &places, at, foreign, random)?;
                Some(changed)
            })?;
        }
    }
    recount(&mut lines);
    let text = write(&lines);
    (text != honest).then_some((kind, text))
}

fn some(places: &[usize], random: &mut Random) -> Option<usize> {
    (!places.is_empty()).then(|| places[random.below(places.len())])
}

fn write(lines: &[Line]) -> String {
    lines.iter().map(|l| l.join(" ") + "\n").collect()
}

fn recount(lines: &mut [Line]) {
    let mut counts: Vec<usize> = Vec::new();
    for line in lines.iter() {
        match line[0].as_str() {
            "begin" => counts.push(0),
            "counts" => break,
            _ => counts.iter_mut().last().into_iter().for_each(|n| *n += 1),
        }
    }
    for line in lines.iter_mut().filter(|l| l[0] == "counts") {
        line.truncate(1);
        line.extend(counts.iter().map(usize::to_string));
    }
}

/// Another number, near.
fn renumber(word: &mut String, random: &mut Random) -> Option<()> {
    let old: i128 = word.parse().ok()?;
    let new = old + [-1, 1, 1, 2, 3][random.below(5)];
    *word = new.max(0).to_string();
    Some(())
}

/// Two vertices change their places in the order.
fn reorder(lines: &mut [Line], random: &mut Random) -> Option<()> {
    let n: usize = lines.iter().find(|l| l[0] == "shell")?[2].parse().ok()?;
    let line = lines.iter_mut().find(|l| l[0] == "order")?;
    let identity: Line = (0..n).map(|v| v.to_string()).collect();
    let mut ids = if line[1] == "id" { identity.clone() } else { line[2..].to_vec() };
    let (i, j) = (random.below(n), random.below(n));
    ids.swap(i, j);
    *line = vec!["order".to_owned()];
    if ids == identity {
        line.push("id".to_owned());
    } else {
        line.push("list".to_owned());
        line.extend(ids);
    }
    Some(())
}

fn fact(
    kind: &str,
    lines: &mut Vec<Line>,
    places: &[usize],
    at: usize,
    foreign: &[String],
    random: &mut Random,
) -> Option<()> {
    let k = random.below(lines[at].len());
    match kind {
        "drop" => drop(lines.remove(at)),
        "double" => {
            let to = at + random.below(2);
            lines.insert(to, lines[at].clone());
        }
        "foreign" => {
            let same = |l: &&String| l.split(' ').next() == Some(lines[at][0].as_str());
            let like: Vec<&String> = foreign.iter().filter(same).collect();
            if like.is_empty() {
                return None;
            }
            let line = like[random.below(like.len())];
            lines[at] = line.split(' ').map(str::to_owned).collect();
        }
        "like" => {
            let same = |i: &&usize| lines[**i][0] == lines[at][0] && lines[**i].len() > k;
            let like: Vec<usize> = places.iter().filter(same).copied().collect();
            lines[at][k] = lines[some(&like, random)?][k].clone();
        }
        "swap" => {
            let n = lines[at].len();
            if n < 3 {
                return None;
            }
            let (i, j) = (1 + random.below(n - 1), 1 + random.below(n - 1));
            lines[at].swap(i, j);
        }
        _ => word(kind, &mut lines[at][k], random)?,
    }
    Some(())
}

/// A change of one word.
fn word(kind: &str, word: &mut String, random: &mut Random) -> Option<()> {
    let (head, list) =
        word.split_once(':').map_or((String::new(), word.clone()), |(h, l)| (h.to_owned(), l.to_owned()));
    let mut parts: Vec<String> = list.split(',').map(str::to_owned).collect();
    let k = random.below(parts.len());
    match kind {
        "id" => {
            let letters = parts[k].len() - parts[k].trim_start_matches(|c: char| !c.is_ascii_digit()).len();
            let mut number = parts[k].split_off(letters);
            renumber(&mut number, random)?;
            parts[k] += &number;
        }
        "layer" => {
            let first = parts[k].chars().next().filter(|c| "bmt".contains(*c) && parts[k].len() > 1)?;
            let others: Vec<char> = "bmt".chars().filter(|c| *c != first).collect();
            parts[k].replace_range(..1, &others[random.below(2)].to_string());
        }
        "plane" => {
            if head.is_empty() {
                return None;
            }
            let (i, other) = (random.below(parts.len()), random.below(3));
            parts.swap(k, i);
            *word = match other {
                0 if parts.len() == 2 => {
                    format!("{}:{}", if head == "l" { "n" } else { "l" }, parts.join(","))
                }
                1 if parts.len() == 3 => format!("l:{},{}", parts[0], parts[1]),
                _ => format!("{head}:{}", parts.join(",")),
            };
            return Some(());
        }
        "sign" => {
            let rest = word.strip_prefix('-').map(str::to_owned);
            word.chars().all(|c| c.is_ascii_digit() || "*^-".contains(c)).then_some(())?;
            *word = rest.unwrap_or_else(|| format!("-{word}"));
            return Some(());
        }
        _ => {
            const REASONS: [&str; 7] = ["cap", "wall", "boundary", "fold", "lands", "twice", "monodromy"];
            let other = REASONS[random.below(7)];
            *word = match word.as_str() {
                "mesh" => "middle",
                "middle" => "mesh",
                w if REASONS.contains(&w) => other,
                _ => return None,
            }
            .to_owned();
            return Some(());
        }
    }
    if head.is_empty() {
        parts.sort_by_key(|p| place(p));
        *word = parts.join(",");
    } else {
        *word = format!("{head}:{}", parts.join(","));
    }
    Some(())
}

/// Ids ascend, names by id and layer.
fn place(part: &str) -> (u64, usize) {
    let digits = part.trim_start_matches(|c: char| !c.is_ascii_digit());
    let layer = part.chars().next().and_then(|c| "bmt".find(c)).unwrap_or(0);
    (digits.parse().unwrap_or(u64::MAX), layer)
}
