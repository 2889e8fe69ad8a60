//! A meter in templates that somebody else wrote: what they build, go through and write is counted against a budget.
//!
//! The engine knows no bounds: `{% set x = x ~ x %}` thirty times is a gigabyte before anything is written, and loops
//! within loops run for ever. It offers no place to count, either, but it calls filters and functions. So the text of a
//! template is changed before it is compiled, within its lines:
//! - `|spent` stands after what `~` and `|` take, after lists and maps written out, and after what `set` keeps and what
//!   `{{ }}` works out: it counts the size of a value;
//! - `|each(body=N)` stands after what a `for` goes through: it counts all turns of the loop before the first;
//! - `{{ included() }}` stands before an `include`.
//!
//! What is written is counted by the writer. An expression has at most 256 operators (the engine's own bound), each takes
//! values that were counted, and filters that multiply count what they will make: so memory and time are bounded by the
//! budget, too. What cannot be counted so (components, blocks, lists made by `for`) is not offered.
use crate::finding::Finding;
use std::cell::Cell;
use std::io;
use tera::{Error, Kwargs, State, StringInput, Tera, TeraResult, Value};

/// What a template may build, go through and write in one rendering, in characters of text, beside [`TIMES`] what it is given.
pub const BUDGET: usize = 1 << 18;
/// How many times a template may go through all that it is given.
pub const TIMES: usize = 8;
/// What one item of a list or map counts beside its text.
const ITEM: usize = 64;
/// What one turn of a loop counts beside its text.
const TURN: usize = 8;
/// What one include counts.
const INCLUDE: usize = 1 << 13;
/// The widest indent that the engine makes.
const INDENT: usize = 1000;
/// Characters of a template at most.
const LONGEST: usize = BUDGET;
/// Branches `elif` of a template at most: the engine reads each one within the one before.
const BRANCHES: usize = 256;

/// What a template that reaches the end of its budget is told.
pub const SPENT: &str = "the text becomes too large, or its loops run too long";
/// What would be right.
pub const SPENT_HINT: &str = "what a template builds (`set`, `~`, filters, `range`), goes through (`for`) and writes may come to \
     262144 characters: write a shorter text, or loop over less";

thread_local! {
    static LEFT: Cell<usize> = const { Cell::new(usize::MAX) };
    static OVER: Cell<bool> = const { Cell::new(false) };
}

/// Begins a rendering that is given this much.
pub fn begin(given: usize) {
    LEFT.set(BUDGET.saturating_add(given.saturating_mul(TIMES)));
    OVER.set(false);
}

/// Did the rendering reach the end of its budget?
pub fn is_over() -> bool {
    OVER.get()
}

fn spend(size: usize) -> Result<(), Error> {
    match LEFT.get().checked_sub(size) {
        Some(left) => {
            LEFT.set(left);
            Ok(())
        }
        None => {
            LEFT.set(0);
            OVER.set(true);
            Err(Error::message(SPENT))
        }
    }
}

/// About how long the text of a value is; it stops counting where `enough` is reached.
pub fn size(value: &Value, enough: usize) -> usize {
    if let Some(text) = value.as_str() {
        return text.len();
    }
    let mut sum: usize = ITEM;
    if let Some(items) = value.as_array() {
        for item in items {
            sum = sum.saturating_add(ITEM);
            if sum > enough {
                break;
            }
            sum = sum.saturating_add(size(item, enough - sum));
        }
    } else if let Some(entries) = value.as_map() {
        for (key, item) in entries {
            sum = sum.saturating_add(ITEM + key.as_str().map_or(0, str::len));
            if sum > enough {
                break;
            }
            sum = sum.saturating_add(size(item, enough - sum));
        }
    } else if let Some(bytes) = value.as_bytes() {
        sum = sum.saturating_add(bytes.len());
    }
    sum
}

/// Counts what is written.
pub struct MeteredWriter<'o>(pub &'o mut Vec<u8>);

impl io::Write for MeteredWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        spend(bytes.len()).map_err(io::Error::other)?;
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Gives an engine the filters and functions that count, and those of its own anew that can multiply.
pub fn equip(engine: &mut Tera) {
    engine.register_filter("spent", |value: Value, _: Kwargs, _: &State| -> TeraResult<Value> {
        spend(1 + size(&value, LEFT.get()))?;
        Ok(value)
    });
    engine.register_filter("each", |value: Value, kwargs: Kwargs, _: &State| -> TeraResult<Value> {
        let body = kwargs.must_get::<usize>("body")?;
        let turns = value.len().unwrap_or(0).saturating_add(1);
        spend(turns.saturating_mul(body.saturating_add(TURN)))?;
        Ok(value)
    });
    engine.register_filter("lines", |value: Value, _: Kwargs, _: &State| -> TeraResult<Value> {
        let lines = value.as_str().map_or(1, |t| t.lines().count().max(1));
        spend(lines.saturating_mul(INDENT))?;
        Ok(value)
    });
    engine.register_function("included", |_: Kwargs, _: &State| -> TeraResult<Value> {
        spend(INCLUDE)?;
        Ok(Value::safe_string(""))
    });
    engine.register_function("range", range);
    engine.register_filter("replace", replace);
    engine.register_filter("join", join);
    engine.register_filter("fill", fill);
}

/// The engine's function of this name, with its arguments; items are counted before there are any.
fn range(kwargs: Kwargs, _: &State) -> TeraResult<Vec<i128>> {
    let start = kwargs.get::<i128>("start")?.unwrap_or_default();
    let end = kwargs.must_get::<i128>("end")?;
    let step = kwargs.get::<i128>("step_by")?.unwrap_or(1);
    if step == 0 {
        return Err(Error::message("Function `range` was called with a `step_by` argument of 0"));
    }
    if start > end && step > 0 {
        return Err(Error::message(
            "Function `range` was called with a `start` argument greater than the `end` one",
        ));
    }
    let mut values = Vec::new();
    let mut next = start;
    while if step > 0 { next < end } else { next > end } {
        spend(TURN)?;
        values.push(next);
        let Some(after) = next.checked_add(step) else { break };
        next = after;
    }
    Ok(values)
}

/// The engine's filter of this name; what it will make is counted first.
fn replace(value: StringInput, kwargs: Kwargs, state: &State) -> TeraResult<Value> {
    let from = kwargs.must_get::<&str>("from")?;
    let to = kwargs.must_get::<StringInput>("to")?;
    let safe = state.autoescaping_enabled() && (value.is_safe() || to.is_safe());
    let (text, to) = if safe {
        (value.rendered(state)?, to.rendered(state)?)
    } else {
        (value.as_str().into(), to.as_str().into())
    };
    let found = text.matches(from).count();
    spend(text.len().saturating_add(found.saturating_mul(to.len())))?;
    let text = text.replace(from, &to);
    Ok(if safe { Value::safe_string(&text) } else { Value::from(text) })
}

/// The engine's filter of this name; what it will make is counted first. The items were counted as what it takes.
fn join(items: &[Value], kwargs: Kwargs, state: &State) -> TeraResult<Value> {
    let between = kwargs.get::<StringInput>("sep")?;
    let safe = state.autoescaping_enabled()
        && (items.iter().any(|x| x.is_string() && x.is_safe())
            || between.as_ref().is_some_and(StringInput::is_safe));
    let separator = match &between {
        Some(text) if safe => text.rendered(state)?.into_owned(),
        Some(text) => text.as_str().to_owned(),
        None => String::new(),
    };
    spend(items.len().saturating_mul(separator.len().saturating_add(1)))?;
    let mut out = String::new();
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            out.push_str(&separator);
        }
        if safe && item.is_undefined() {
            continue;
        }
        let piece = if safe { state.escape_if_needed(item)? } else { item.to_string() };
        spend(piece.len())?;
        out.push_str(&piece);
    }
    Ok(if safe { Value::safe_string(&out) } else { Value::from(out) })
}

/// `{{ words.of | fill(n=3, of=4) }}`: a phrase with its places filled in.
fn fill(phrase: StringInput, kwargs: Kwargs, state: &State) -> TeraResult<Value> {
    let is_safe = phrase.is_safe();
    let piece = |text: &str| match is_safe {
        true => Ok(text.to_owned()),
        false => state.escape_if_needed(&Value::normal_string(text)),
    };
    let mut out = String::new();
    let mut rest = phrase.as_str();
    while let Some((before, behind)) = rest.split_once('{') {
        let Some((place, after)) = behind.split_once('}') else { break };
        let is_name = place.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && !place.is_empty();
        if !is_name {
            out.push_str(&piece(&rest[..=before.len()])?);
            rest = behind;
            continue;
        }
        let value = kwargs.iter().find(|(name, _)| name.as_str() == Some(place)).map(|(_, value)| value);
        let value = value.ok_or_else(|| Error::message(format!("nothing fills the place {{{place}}}")))?;
        out.push_str(&piece(before)?);
        let text = state.escape_if_needed(value)?;
        spend(text.len())?;
        out.push_str(&text);
        rest = after;
    }
    out.push_str(&piece(rest)?);
    Ok(if state.autoescaping_enabled() { Value::safe_string(&out) } else { Value::from(out) })
}

/// The text of a template with its meter.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Metered {
    pub text: String,
    /// What stands in it more: line (from 1), column (from 0, in characters) in the new text, and how many characters.
    added: Vec<(usize, usize, usize)>,
}

impl Metered {
    /// The column that a place of the new text has in the old one; both from 0.
    pub fn column(&self, line: usize, column: usize) -> usize {
        let mut shift = 0;
        for (_, at, length) in self.added.iter().filter(|(l, at, _)| *l == line && *at < column) {
            shift += (*length).min(column - at);
        }
        column - shift
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Token<'t> {
    Word(&'t str),
    /// A text or a number.
    Plain,
    Sign(char),
}

/// `{{ ... }}` or `{% ... %}`.
struct Tag<'t> {
    start: usize,
    end: usize,
    is_value: bool,
    trims: bool,
    /// With where each begins and ends.
    tokens: Vec<(Token<'t>, usize, usize)>,
}

impl<'t> Tag<'t> {
    fn token(&self, i: usize) -> Option<Token<'t>> {
        self.tokens.get(i).map(|(token, ..)| *token)
    }
    /// The word that a tag begins with; none of a value.
    fn name(&self) -> &'t str {
        match self.token(0) {
            Some(Token::Word(word)) if !self.is_value => word,
            _ => "",
        }
    }
    fn begins_capture(&self) -> bool {
        match self.name() {
            "filter" => true,
            "set" | "set_global" => self.token(2) != Some(Token::Sign('=')),
            _ => false,
        }
    }
    /// Nothing but a name, such as `loop.index`.
    fn is_path(&self) -> bool {
        self.tokens.iter().enumerate().all(|(i, (token, ..))| match token {
            Token::Word(_) => i % 2 == 0,
            Token::Sign(sign) => i % 2 == 1 && *sign == '.',
            Token::Plain => false,
        })
    }
}

/// Puts the meter behind every value that a tag makes on the way: between filters, around lists and maps written out. Errors: a
/// list made by `for`: where it stands, what is wrong, what would be right.
fn spend_in_tag(
    tag: &Tag,
    first: usize,
    edits: &mut Vec<(usize, String)>,
) -> Result<(), (usize, &'static str, &'static str)> {
    // Brackets that are open: does each hold a list or map written out?
    let mut open: Vec<bool> = Vec::new();
    for (i, (token, start, end)) in tag.tokens.iter().enumerate().skip(first) {
        let before = if i > first { tag.token(i - 1) } else { None };
        match token {
            Token::Word("for") => {
                return Err((
                    *start,
                    "a list made by `for` is not offered",
                    "write a loop, `{% for x in list %}...{% endfor %}`",
                ));
            }
            Token::Sign('~' | '|') => {
                let indents = tag.token(i + 1) == Some(Token::Word("indent"));
                edits.push((*start, if indents { "|spent|lines " } else { "|spent " }.to_owned()));
            }
            Token::Sign('[' | '{') => {
                let follows = match before {
                    Some(Token::Word(w)) => !matches!(w, "in" | "and" | "or" | "not" | "if" | "else" | "is"),
                    Some(Token::Plain) => true,
                    Some(Token::Sign(sign)) => matches!(sign, ')' | ']' | '}' | '?'),
                    None => false,
                };
                if !follows {
                    edits.push((*start, "(".to_owned()));
                }
                open.push(!follows);
            }
            Token::Sign(']' | '}') => {
                edits.extend((open.pop() == Some(true)).then(|| (*end, "|spent)".to_owned())));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Puts the meter into the text of a template; None where it needs none. Errors: what is not offered, with line and column.
pub fn metered(text: &str) -> Result<Option<Metered>, Finding> {
    let refuse = |at: usize, message: String, hint: &str| {
        let before = text.get(..at).unwrap_or(text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        Err(Finding::new("", format!("template: {message}")).hint(hint).at(line, column))
    };
    if text.len() > LONGEST {
        return refuse(0, format!("has {} characters", text.len()), "a template has at most 262144");
    }
    let tags = tags(text);
    let keeps = tags.iter().any(|t| matches!(t.name(), "set" | "set_global" | "filter"));
    let mut edits: Vec<(usize, String)> = Vec::new();
    // Loops that are open: the edit that says how long their text is, and where it begins.
    let mut loops: Vec<(usize, usize)> = Vec::new();
    let (mut captures, mut branches) = (0usize, 0usize);
    for tag in &tags {
        let mut first = 1;
        match tag.name() {
            name @ ("component" | "block" | "extends") => {
                return refuse(
                    tag.start,
                    format!("`{name}` is not offered"),
                    "write the text itself, or put it into a file and `include` it",
                );
            }
            "elif" => {
                branches += 1;
                if branches > BRANCHES {
                    let hint = format!("a template has at most {BRANCHES}");
                    return refuse(tag.start, "one `elif` too many".to_owned(), &hint);
                }
            }
            "include" if captures > 0 => {
                return refuse(
                    tag.start,
                    "`include` is not offered within `set` or `filter`".to_owned(),
                    "put it before or after",
                );
            }
            "include" => {
                let call = if tag.trims { "{{- included() -}}" } else { "{{ included() }}" };
                edits.push((tag.start, call.to_owned()));
            }
            "endset" | "endfilter" => captures = captures.saturating_sub(1),
            "endfor" => {
                if let Some((edit, from)) = loops.pop()
                    && let Some((_, insert)) = edits.get_mut(edit)
                {
                    *insert = format!(")|each(body={})", tag.start.saturating_sub(from));
                }
            }
            "" if tag.is_value => first = 0,
            _ => {}
        }
        if tag.begins_capture() {
            captures += 1;
        }
        // What is worked out as a whole: the value of `set`, what `for` goes through, what is written.
        let whole = match tag.name() {
            "set" | "set_global" if !tag.begins_capture() => Some(3),
            "for" => tag.tokens.iter().position(|(t, ..)| *t == Token::Word("in")).map(|i| i + 1),
            "" if tag.is_value && (!tag.is_path() || keeps) => Some(0),
            _ => None,
        };
        let whole = whole.filter(|i| *i < tag.tokens.len());
        if let Some((_, start, _)) = whole.and_then(|i| tag.tokens.get(i)) {
            edits.push((*start, "(".to_owned()));
        }
        if tag.name() == "filter"
            && let Some((token, start, _)) = tag.tokens.get(1)
        {
            let counts = if *token == Token::Word("indent") { "spent|lines|" } else { "spent|" };
            edits.push((*start, counts.to_owned()));
        }
        if let Err((at, message, hint)) = spend_in_tag(tag, first, &mut edits) {
            return refuse(at, message.to_owned(), hint);
        }
        if whole.is_some()
            && let Some((_, _, end)) = tag.tokens.last()
        {
            if tag.name() == "for" {
                loops.push((edits.len(), tag.end));
                edits.push((*end, String::new()));
            } else {
                edits.push((*end, ")|spent".to_owned()));
            }
        } else if tag.name() == "for" {
            loops.push((usize::MAX, tag.end));
        }
    }
    if edits.is_empty() {
        return Ok(None);
    }
    Ok(Some(inserted(text, edits)))
}

/// The text with these pieces put in, each at its place in the old text.
fn inserted(text: &str, edits: Vec<(usize, String)>) -> Metered {
    let mut out = Metered { text: String::with_capacity(text.len() * 2), added: Vec::new() };
    let (mut from, mut line, mut column) = (0, 1, 0);
    for (at, insert) in edits {
        let piece = text.get(from..at).unwrap_or_default();
        match piece.rfind('\n') {
            Some(end) => {
                line += piece.matches('\n').count();
                column = piece[end + 1..].chars().count();
            }
            None => column += piece.chars().count(),
        }
        out.text.push_str(piece);
        out.text.push_str(&insert);
        out.added.push((line, column, insert.len()));
        column += insert.len();
        from = at;
    }
    out.text.push_str(text.get(from..).unwrap_or_default());
    out
}

/// The tags of a template, read as the engine reads them; what it would refuse may come out as anything.
fn tags(text: &str) -> Vec<Tag<'_>> {
    let bytes = text.as_bytes();
    let mut tags = Vec::new();
    let mut at = 0;
    while let Some(more) = text.get(at..).and_then(|rest| rest.find('{')) {
        at += more;
        match bytes.get(at + 1) {
            Some(b'#') => at = text[at + 2..].find("#}").map_or(text.len(), |end| at + 2 + end + 2),
            Some(b'%') => {
                at = match after_raw(text, at) {
                    Some(end) => end,
                    None => tag(text, at, false, &mut tags),
                };
            }
            Some(b'{') => at = tag(text, at, true, &mut tags),
            _ => at += 1,
        }
    }
    tags
}

/// Where a part that is not read at all ends, if one begins here.
fn after_raw(text: &str, at: usize) -> Option<usize> {
    let tag = |at: usize, name: &str| {
        let rest = text.get(at + 2..)?;
        let rest =
            rest.strip_prefix('-').unwrap_or(rest).trim_start_matches(|c: char| c.is_ascii_whitespace());
        let rest = rest.strip_prefix(name)?.trim_start_matches(|c: char| c.is_ascii_whitespace());
        let rest = rest.strip_prefix('-').unwrap_or(rest).strip_prefix("%}")?;
        Some(text.len() - rest.len())
    };
    let mut from = tag(at, "raw")?;
    while let Some(next) = text.get(from..).and_then(|rest| rest.find("{%")) {
        if let Some(end) = tag(from + next, "endraw") {
            return Some(end);
        }
        from += next + 2;
    }
    Some(text.len())
}

/// Reads one tag and tells where it ends.
fn tag<'t>(text: &'t str, start: usize, is_value: bool, tags: &mut Vec<Tag<'t>>) -> usize {
    let close = if is_value { "}}" } else { "%}" };
    let trims = text[start + 2..].starts_with('-');
    let mut at = start + 2 + usize::from(trims);
    let mut tokens = Vec::new();
    while let Some(c) = text.get(at..).and_then(|rest| rest.chars().next()) {
        let rest = &text[at..];
        if rest.starts_with(close) || rest.strip_prefix('-').is_some_and(|r| r.starts_with(close)) {
            at += if c == '-' { 3 } else { 2 };
            break;
        }
        let length = |keep: fn(char) -> bool| rest.find(|c| !keep(c)).unwrap_or(rest.len());
        let (token, length) = match c {
            c if c.is_ascii_whitespace() => (None, 1),
            '"' | '\'' | '`' => {
                let mut escaped = false;
                let end = rest[1..].bytes().position(|b| {
                    let ends = !escaped && char::from(b) == c;
                    escaped = !escaped && b == b'\\';
                    ends
                });
                (Some(Token::Plain), end.map_or(rest.len(), |end| end + 2))
            }
            c if c.is_ascii_digit() => (Some(Token::Plain), length(|c| c.is_ascii_digit() || c == '.')),
            c if c.is_alphabetic() || c == '_' => {
                let length = length(|c| c.is_alphanumeric() || c == '_');
                (Some(Token::Word(&rest[..length])), length)
            }
            c => (Some(Token::Sign(c)), c.len_utf8()),
        };
        if let Some(token) = token {
            tokens.push((token, at, at + length));
        }
        at += length;
    }
    tags.push(Tag { start, end: at, is_value, trims, tokens });
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::template::{Templates, View};

    fn rendered(text: &str) -> Result<String, String> {
        let own = ("x.html".to_owned(), "x.html".to_owned(), text.to_owned());
        let templates = Templates::new("en", &[own]).unwrap();
        let mut view = View::new();
        view.foreign("phrase", "{n} <of> {m} {} {a b}");
        view.foreign("name", "<b>");
        view.text("code", "<code>1</code>");
        let mut out = Vec::new();
        templates.render("x.html", &view, &mut out).map_err(|fault| fault.message)?;
        Ok(String::from_utf8(out).unwrap())
    }

    #[test]
    fn phrases_are_filled_and_escaped() {
        let page = rendered("{{ phrase | fill(n=name, m=code) }}").unwrap();
        assert!(page.ends_with("&lt;b&gt; &lt;of&gt; <code>1</code> {} {a b}"), "{page}");
        let fault = rendered("{{ phrase | fill(n=name) }}").unwrap_err();
        assert!(fault.contains("nothing fills the place {m}"), "{fault}");
    }

    #[test]
    fn what_is_filled_in_is_counted() {
        let mut text = format!("{{% set x = \"{}\" %}}", "{a}".repeat(20));
        text.push_str(&"{% set x = x | fill(a=x) %}".repeat(9));
        let fault = rendered(&text).unwrap_err();
        assert!(fault.contains(SPENT), "{fault}");
    }
}
