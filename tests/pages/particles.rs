//! Makes of a worked solution what a reader of plain formulas understands: tables and sums over particles written out, pi (and
//! half a turn, which is no datum) as a number, a value alone as an equation.

/// Pi, as long as a double.
const PI: &str = "3.14159265358979";

/// The text up to its answers, in plain formulas.
pub fn plain(markdown: &str) -> String {
    let body =
        markdown.split("\n### ").take_while(|s| !s.starts_with("Answers") && !s.starts_with("Ergebnisse"));
    let body: Vec<&str> = body.collect();
    let text =
        body.join("\n### ").replace(r"\Delta ", r"\Delta_").replace(r"\pi", PI).replace(r"180^\circ", PI);
    let labels = labels(&text);
    let mut out: Vec<String> = Vec::new();
    let mut definitions = Vec::new();
    let mut count = 0;
    for block in text.split("\n\n") {
        if block.starts_with('|') {
            out.extend(table(block, &mut count));
        } else if let Some(formula) = block.strip_prefix("$$").and_then(|b| b.strip_suffix("$$")) {
            if formula.contains(r"^{2} &= ") {
                out.push(format!("$${}$$", under_root(formula)));
            } else if formula.contains(r"\sum") {
                out.push(format!("$${}$$", written_out(formula, &labels)));
            } else if formula.contains("_i") || formula.contains(",i}") {
                definitions.extend(labels.iter().map(|l| format!("$${}$$", of(formula, l))));
            } else if let Some((name, value)) = formula.split_once(" = ").filter(|(_, v)| is_number(v)) {
                out.push(format!("$${name} = {value} = {value}$$"));
            } else {
                out.push(block.to_owned());
            }
        } else {
            out.push(block.to_owned());
        }
    }
    out.extend(definitions);
    out.join("\n\n")
}

/// A root whose square is told: `s = ... \\ s^2 = ... \\ s = value` as one chain.
fn under_root(formula: &str) -> String {
    let name = formula.trim_start_matches(r"\begin{aligned} ").split(" &= ").next().unwrap_or("").to_owned();
    let square = format!(r" \\ {name}^{{2}} &= ");
    let (Some((head, rest)), result) = (formula.split_once(&square), format!(r" \\ {name} &= ")) else {
        return formula.to_owned();
    };
    format!(r"{head} \\ &= \sqrt{{{}", rest.replace(&result, r"} \\ &= "))
}

fn is_number(text: &str) -> bool {
    text.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit())
        && !text.contains(['=', '+', '(', '&'])
}

/// What an expression in `i` is for one particle.
fn of(expression: &str, label: &str) -> String {
    expression.replace("_i", &format!("_{label}")).replace(",i}", &format!(",{label}}}"))
}

/// The particles: first column of the first table over them.
fn labels(text: &str) -> Vec<String> {
    let block = text.split("\n\n").find(|b| b.starts_with("| $i$ "));
    let rows = block.into_iter().flat_map(str::lines).skip(2);
    rows.filter_map(|r| r.split('$').nth(1).map(str::to_owned)).collect()
}

/// A table over the particles as equations; no other table says any.
fn table(block: &str, count: &mut u32) -> Vec<String> {
    let cells = |row: &str| -> Vec<String> {
        let row = row.trim().trim_matches('|');
        row.split(" | ").map(|c| c.trim().trim_matches('$').to_owned()).collect()
    };
    let mut rows = block.lines();
    let head = rows.next().map(cells).unwrap_or_default();
    if head.first().map(String::as_str) != Some("i") {
        return Vec::new();
    }
    let mut out = Vec::new();
    for row in rows.skip(1).map(cells) {
        for (name, value) in head.iter().zip(&row).skip(1) {
            let name = name.split('$').next().unwrap_or("");
            if ["m_i", "x_i", "y_i"].contains(&name) {
                continue;
            }
            let this = of(name, &row[0]);
            *count += 1;
            let single = !name.contains([' ', '+']) && !name.contains(r"\,");
            out.push(match single {
                true => format!("$${this} = {value} = {value}$$"),
                false => format!("$$c_{{{}}} = {this} = {value}$$", *count),
            });
        }
    }
    out
}

/// Each sum over the particles as the sum of its terms.
fn written_out(formula: &str, labels: &[String]) -> String {
    let mut out = String::new();
    let mut rest = formula;
    while let Some((before, after)) = rest.split_once(r"\sum ") {
        out.push_str(before);
        let mut depth = 0;
        let end = after.char_indices().find(|(i, c)| {
            let here = &after[*i..];
            match c {
                '{' | '(' => depth += 1,
                '}' | ')' => depth -= 1,
                _ => {}
            }
            depth < 0 || depth == 0 && [" + ", " - ", " = ", r" \\"].iter().any(|e| here.starts_with(e))
        });
        let (term, next) = after.split_at(end.map_or(after.len(), |(i, _)| i));
        let terms: Vec<String> = labels.iter().map(|l| of(term, l)).collect();
        out.push_str(&format!(r"\left({}\right)", terms.join(" + ")));
        rest = next;
    }
    out.push_str(rest);
    out
}
