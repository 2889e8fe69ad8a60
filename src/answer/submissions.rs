//! A file of submissions as spreadsheets and form services write it: a stream of bytes to batches of records with their
//! lines, never the whole file in memory.
//!
//! The reader is our own and not the `csv` crate's, because one quote left open must not swallow the rest: such a quote is
//! taken as an ordinary character, and the reader goes on at the next line. A quote is left open where no closing one
//! follows within 64 KiB or 100 lines, where text follows a closing quote on a later line, or where each of the lines up to
//! the closing quote has as many fields as the header. Everything else is as in RFC 4180.
use encoding_rs::{Encoding, UTF_16BE, UTF_16LE, WINDOWS_1252};
use std::borrow::Cow;
use std::io::{self, Read};
use std::ops::Range;

/// A field longer than this cannot be read.
const FIELD_CAP: usize = 64 * 1024;
/// A quoted field with more lines than this was not meant as one.
const LINE_CAP: u64 = 100;
/// A record must be decided within this many bytes.
const LOOKAHEAD: usize = 2 * FIELD_CAP;
/// Bytes of an overlong record that are kept to show it.
const SHOWN: usize = 120;

/// Where a field stands; quotes are not yet taken off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct FieldSpan {
    start: usize,
    end: usize,
    quoted: bool,
    /// A quote at its start is an ordinary character: it is not closed.
    open: bool,
}

/// How fields are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct FileShape {
    delimiter: u8,
    /// Fields of the header; 0 where they are not known.
    width: usize,
}

/// Places of delimiters and of LF, in order; eight bytes at a time.
fn find_marks(data: &[u8], delimiter: u8, marks: &mut Vec<u32>) {
    const ONES: u64 = 0x0101_0101_0101_0101;
    const LOW: u64 = 0x7f7f_7f7f_7f7f_7f7f;
    marks.clear();
    // The high bit of each byte that is zero, and no other.
    let zeros = |x: u64| !(((x & LOW) + LOW) | x | LOW);
    let (delimiters, ends) = (ONES * u64::from(delimiter), ONES * u64::from(b'\n'));
    let mut words = data.chunks_exact(8);
    let mut base = 0u32;
    for word in &mut words {
        let word = word.try_into().map_or(0, u64::from_le_bytes);
        let mut hits = zeros(word ^ delimiters) | zeros(word ^ ends);
        while hits != 0 {
            marks.push(base + (hits.trailing_zeros() >> 3));
            hits &= hits - 1;
        }
        base += 8;
    }
    for (i, b) in (base..).zip(words.remainder()) {
        if *b == delimiter || *b == b'\n' {
            marks.push(i);
        }
    }
}

/// Where a record ends, where the next one begins, and how many lines it took.
struct Walked {
    end: usize,
    next: usize,
    lines: u64,
}

/// The line end at `at`: where the next line begins; `None` if a CR is the last byte and more may come.
fn line_end(data: &[u8], at: usize, whole: bool) -> Option<usize> {
    match (data[at], data.get(at + 1)) {
        (b'\n', _) => Some(at + 1),
        (_, Some(b'\n')) => Some(at + 2),
        (_, None) if !whole => None,
        _ => Some(at + 1),
    }
}

/// Walks over one record. `None`: more bytes are needed to decide; never where `whole` says that nothing follows.
fn walk(
    data: &[u8],
    from: usize,
    shape: FileShape,
    whole: bool,
    field: &mut dyn FnMut(FieldSpan),
) -> Option<Walked> {
    let delimiter = shape.delimiter;
    let (mut at, mut lines) = (from, 0);
    loop {
        let blanks = data[at..].iter().take_while(|b| **b == b' ').count();
        let quote = at + blanks;
        let is_quoted = data.get(quote) == Some(&b'"');
        let closed = if is_quoted { closing(data, quote + 1, shape, whole)? } else { None };
        let end = if let Some((close, inner)) = closed {
            field(FieldSpan { start: quote, end: close, quoted: true, open: false });
            lines += inner;
            close
        } else {
            let rest = &data[at..];
            let stop = memchr::memchr3(delimiter, b'\n', b'\r', rest);
            if stop.is_none() && !whole {
                return None;
            }
            let end = at + stop.unwrap_or(rest.len());
            field(FieldSpan { start: at, end, quoted: false, open: is_quoted });
            end
        };
        match data.get(end) {
            None if !whole => return None,
            None => return Some(Walked { end, next: end, lines: lines + 1 }),
            Some(&b) if b == delimiter => at = end + 1,
            Some(_) => {
                let next = line_end(data, end, whole)?;
                return Some(Walked { end, next, lines: lines + 1 });
            }
        }
    }
}

/// The end of a quoted field that begins at `from` (after its quote), and the line ends inside. `None`: undecided;
/// `Some(None)`: the quote is an ordinary character.
fn closing(data: &[u8], from: usize, shape: FileShape, whole: bool) -> Option<Option<(usize, u64)>> {
    let delimiter = shape.delimiter;
    let (mut at, mut lines) = (from, 0);
    let mut second = from; // where the line after the quote's begins
    let limit = data.len().min(from + FIELD_CAP);
    loop {
        let Some(step) = memchr::memchr3(b'"', b'\n', b'\r', &data[at.min(limit)..limit]) else {
            return if limit == from + FIELD_CAP || whole { Some(None) } else { None };
        };
        at += step;
        if data[at] != b'"' {
            lines += 1;
            if lines > LINE_CAP {
                return Some(None);
            }
            at = line_end(data, at, whole)?;
            if lines == 1 {
                second = at;
            }
            continue;
        }
        match data.get(at + 1) {
            Some(b'"') => at += 2,
            None if !whole => return None,
            _ => {
                // what follows the closing quote up to the delimiter belongs to the field: `"5" rod`
                let rest = &data[at + 1..];
                let stop = memchr::memchr3(delimiter, b'\n', b'\r', rest);
                if stop.is_none() && !whole {
                    return if rest.len() > FIELD_CAP { Some(None) } else { None };
                }
                let end = at + 1 + stop.unwrap_or(rest.len());
                let junk = data[at + 1..end].iter().any(|b| *b != b' ');
                if lines == 0 {
                    return Some(Some((end, lines)));
                }
                return Some(if junk || all_records_look(data, second, at, shape, whole)? {
                    None
                } else {
                    Some((end, lines))
                });
            }
        }
    }
}

/// Has each line from `from` to the one in which `close` stands as many fields as the header? Then a quote before them
/// was left open, and the quote at `close` is another's. `None`: undecided.
fn all_records_look(data: &[u8], from: usize, close: usize, shape: FileShape, whole: bool) -> Option<bool> {
    if shape.width < 2 {
        return Some(false);
    }
    let reach = &data[close..data.len().min(close + FIELD_CAP)];
    let end = match memchr::memchr2(b'\n', b'\r', reach) {
        Some(k) => close + k,
        None if reach.len() == FIELD_CAP => return Some(false),
        None if whole => data.len(),
        None => return None,
    };
    let lines = data[from..end].split(|b| matches!(b, b'\n' | b'\r')).filter(|line| !line.is_empty());
    let fields = |line: &[u8]| memchr::memchr_iter(shape.delimiter, line).count() + 1;
    Some(lines.map(fields).all(|n| n == shape.width))
}

/// A field's text without its quotes, blanks around it kept.
fn unquoted<'a>(data: &'a [u8], span: FieldSpan) -> Cow<'a, [u8]> {
    let text = &data[span.start..span.end];
    if !span.quoted {
        return Cow::Borrowed(text);
    }
    let inside = &text[1..];
    if let Some(close) = memchr::memchr(b'"', inside)
        && inside[close + 1..].iter().all(|b| *b == b' ')
    {
        return Cow::Borrowed(&inside[..close]);
    }
    let mut out = Vec::with_capacity(inside.len());
    let (mut at, mut open) = (0, true);
    while at < inside.len() {
        if inside[at] == b'"' && open {
            if inside.get(at + 1) == Some(&b'"') {
                at += 1;
            } else {
                open = false;
                at += 1;
                continue;
            }
        }
        out.push(inside[at]);
        at += 1;
    }
    if !open {
        while out.last() == Some(&b' ') {
            out.pop();
        }
    }
    Cow::Owned(out)
}

/// Some whole records, cut from the stream.
#[derive(Debug, Default)]
pub struct Batch {
    bytes: Vec<u8>,
    line: u64,
    shape: FileShape,
    /// No quote and no lone CR inside.
    simple: bool,
    /// A record that was too long to hold: its first bytes.
    overlong: bool,
    /// Encoded as UTF-16 before: replacement characters mean bytes that could not be read.
    decoded: bool,
    /// How many bytes of the file have been read so far.
    pub read_so_far: u64,
    /// How many batches came before.
    pub number: u64,
}

/// One record: its line and its fields.
#[derive(Debug, Clone, Copy)]
pub struct Record<'b> {
    /// Line of the file on which it begins, from 1.
    pub line: u64,
    /// What the fields are cut from: the record, or all of a simple batch.
    text: &'b [u8],
    ends: &'b [(usize, usize)],
    /// Why it cannot be read.
    pub fault: Option<RecordFault>,
    /// Does a field begin with a quote that is not closed?
    pub open: bool,
}

/// What reading records needs, kept from batch to batch.
#[derive(Debug, Default)]
pub struct RecordScratch {
    text: Vec<u8>,
    ends: Vec<(usize, usize)>,
    /// Delimiters and line ends of a simple batch.
    marks: Vec<u32>,
}

/// Why the bytes of a record cannot be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordFault {
    /// NUL or bytes that are no text in any accepted encoding.
    Bytes,
    /// A field beyond 64 KiB.
    TooLong,
}

impl<'b> Record<'b> {
    /// Number of fields.
    pub fn len(&self) -> usize {
        self.ends.len()
    }
    /// Has it no field at all?
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }
    /// A field, without quotes.
    #[inline]
    pub fn get(&self, index: usize) -> Option<&'b [u8]> {
        self.ends.get(index).map(|(a, b)| &self.text[*a..*b])
    }
    /// The whole record on one line, cut where it is long, to show it.
    pub fn shown(&self, delimiter: u8) -> String {
        let mut all = Vec::new();
        for i in 0..self.ends.len() {
            if i > 0 {
                all.push(delimiter);
            }
            all.extend_from_slice(self.get(i).unwrap_or_default());
            if all.len() > 4 * SHOWN {
                break;
            }
        }
        let text = String::from_utf8_lossy(&all);
        let mut out: String =
            text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).take(SHOWN).collect();
        if text.chars().count() > SHOWN {
            out.push('…');
        }
        out
    }
}

impl Batch {
    /// Calls `each` for every record; blank lines are passed over.
    pub fn records(&self, scratch: &mut RecordScratch, mut each: impl FnMut(&Record)) {
        let utf8 = std::str::from_utf8(&self.bytes).is_ok();
        let nul = memchr::memchr(0, &self.bytes).is_some();
        let RecordScratch { text, ends, marks } = scratch;
        let mut line = self.line;
        if self.overlong {
            text.clear();
            text.extend_from_slice(String::from_utf8_lossy(&self.bytes).as_bytes());
            ends.clear();
            ends.push((0, text.len()));
            return each(&Record { line, text, ends, fault: Some(RecordFault::TooLong), open: false });
        }
        let data = &self.bytes;
        let text_alone = utf8 && !nul && !self.decoded;
        let mut at = 0;
        while at < data.len() {
            if text_alone {
                // Lines before the next quote need no care.
                let plain = if self.simple { data.len() } else { at + plain_lines(&data[at..]) };
                if plain > at {
                    line = self.simple_records(at..plain, line, marks, ends, &mut each);
                    at = plain;
                    continue;
                }
            }
            let Some(walked) = walk(data, at, self.shape, true, &mut |_| {}) else { break };
            let raw = &data[at..walked.end];
            if !raw.is_empty() {
                let (fault, open) = self.careful(raw, text, ends);
                each(&Record { line, text, ends, fault, open });
            }
            at = walked.next;
            line += walked.lines;
        }
    }

    /// The records of a part of a batch in which every delimiter and every line end is one: no quote, no byte that is no
    /// text. Gives the line behind it.
    #[inline]
    fn simple_records(
        &self,
        part: Range<usize>,
        mut line: u64,
        marks: &mut Vec<u32>,
        ends: &mut Vec<(usize, usize)>,
        each: &mut impl FnMut(&Record),
    ) -> u64 {
        let text = &self.bytes[part];
        find_marks(text, self.shape.delimiter, marks);
        // The last line may have no end.
        if text.last() != Some(&b'\n') {
            marks.push(u32::try_from(text.len()).unwrap_or(u32::MAX));
        }
        ends.clear();
        let (mut begin, mut start) = (0, 0);
        for mark in marks.iter().map(|m| *m as usize) {
            if text.get(mark).is_some_and(|b| *b != b'\n') {
                ends.push((start, mark));
                start = mark + 1;
                continue;
            }
            let end = if mark > start && text[mark - 1] == b'\r' { mark - 1 } else { mark };
            if end > begin {
                ends.push((start, end));
                let fault = if end - begin >= 256 { self.check(&text[begin..end], ends) } else { None };
                each(&Record { line, text, ends, fault, open: false });
            }
            ends.clear();
            line += 1;
            start = mark + 1;
            begin = start;
        }
        line
    }

    /// Splits one record with quotes or odd bytes: its fault, and whether a quote is left open.
    fn careful(
        &self,
        raw: &[u8],
        text: &mut Vec<u8>,
        ends: &mut Vec<(usize, usize)>,
    ) -> (Option<RecordFault>, bool) {
        let raw = decoded(raw);
        let raw = raw.as_ref();
        text.clear();
        ends.clear();
        let mut open = false;
        walk(raw, 0, self.shape, true, &mut |span| {
            open |= span.open;
            let start = text.len();
            text.extend_from_slice(&unquoted(raw, span));
            ends.push((start, text.len()));
        });
        (self.check(text, ends), open)
    }

    fn check(&self, text: &[u8], ends: &[(usize, usize)]) -> Option<RecordFault> {
        if ends.iter().any(|(a, b)| b - a > FIELD_CAP) {
            return Some(RecordFault::TooLong);
        }
        let odd = memchr::memchr(0, text).is_some()
            || (self.decoded && memchr::memmem::find(text, "\u{fffd}".as_bytes()).is_some())
            // Windows-1252 leaves five bytes undefined; they come out as controls U+0081..U+009D
            || text.windows(2).any(|w| w[0] == 0xc2 && matches!(w[1], 0x81 | 0x8d | 0x8f | 0x90 | 0x9d));
        odd.then_some(RecordFault::Bytes)
    }
}

/// UTF-8, or else Windows-1252.
fn decoded(raw: &[u8]) -> Cow<'_, [u8]> {
    if std::str::from_utf8(raw).is_ok() {
        return Cow::Borrowed(raw);
    }
    let (text, _) = WINDOWS_1252.decode_without_bom_handling(raw);
    Cow::Owned(text.into_owned().into_bytes())
}

/// The stream: finds the encoding and the delimiter, gives the header, then batches.
pub struct RecordSource {
    inner: Box<dyn Read + Send>,
    decoder: Option<encoding_rs::Decoder>,
    decoded: bool,
    buffer: Vec<u8>,
    start: usize,
    finished: bool,
    line: u64,
    shape: FileShape,
    read_so_far: u64,
    batches: u64,
    skipping: bool,
    block: usize,
}

/// The first record of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Header {
    /// Fields, trimmed.
    pub fields: Vec<String>,
    /// Its line.
    pub line: u64,
    /// Found between the fields.
    pub delimiter: u8,
}

impl RecordSource {
    /// Begins to read; the header is `None` in a file without any record. Errors: those of the reader.
    pub fn open(inner: Box<dyn Read + Send>) -> io::Result<(RecordSource, Option<Header>)> {
        RecordSource::with_block(inner, 192 * 1024)
    }

    /// As `open`, reading blocks of at least this many bytes.
    pub(crate) fn with_block(
        inner: Box<dyn Read + Send>,
        block: usize,
    ) -> io::Result<(RecordSource, Option<Header>)> {
        let mut source = RecordSource {
            inner,
            decoder: None,
            decoded: false,
            buffer: Vec::new(),
            start: 0,
            finished: false,
            line: 1,
            shape: FileShape { delimiter: b',', width: 0 },
            read_so_far: 0,
            batches: 0,
            skipping: false,
            block: block.max(16),
        };
        source.fill(LOOKAHEAD)?;
        if let Some(what) = foreign(source.rest()) {
            let said = format!(
                "it is {what}, not a CSV file: open it, save the sheet as CSV (UTF-8), and give that file"
            );
            return Err(io::Error::new(io::ErrorKind::InvalidData, said));
        }
        source.find_encoding();
        source.fill(LOOKAHEAD)?;
        source.skip_blank_lines();
        let mut sep = None;
        let head = source.rest();
        if head.len() > 4 && head[..4].eq_ignore_ascii_case(b"sep=") {
            let end = memchr::memchr2(b'\n', b'\r', head).unwrap_or(head.len());
            if end == 5 {
                sep = Some(head[4]);
                let next = if end < head.len() { line_end(head, end, true).unwrap_or(end) } else { end };
                source.start += next;
                source.line += 1;
                source.skip_blank_lines();
            }
        }
        let head = source.rest();
        if head.is_empty() {
            return Ok((source, None));
        }
        let delimiter = sep.unwrap_or_else(|| sniff(head));
        let mut spans = Vec::new();
        let walked = walk(head, 0, FileShape { delimiter, width: 0 }, true, &mut |span| spans.push(span));
        let text = |span: &FieldSpan| {
            let raw = unquoted(head, *span);
            String::from_utf8_lossy(&decoded(&raw)).trim().to_owned()
        };
        let mut fields: Vec<String> = spans.iter().take(4096).map(text).collect();
        while fields.len() > 1 && fields.last().is_some_and(String::is_empty) {
            fields.pop();
        }
        let header = Header { fields, line: source.line, delimiter };
        source.shape = FileShape { delimiter, width: header.fields.len() };
        if let Some(walked) = walked {
            source.start += walked.next;
            source.line += walked.lines;
        }
        Ok((source, Some(header)))
    }

    fn rest(&self) -> &[u8] {
        &self.buffer[self.start..]
    }

    fn skip_blank_lines(&mut self) {
        while let Some(b'\n' | b'\r') = self.rest().first() {
            let next = line_end(self.rest(), 0, true).unwrap_or(1);
            self.start += next;
            self.line += 1;
        }
    }

    /// Looks at the first bytes; nothing has been taken yet.
    fn find_encoding(&mut self) {
        let head = &self.buffer[..self.buffer.len().min(256)];
        let utf16: Option<&'static Encoding> = match head {
            [0xef, 0xbb, 0xbf, ..] => {
                self.start = 3;
                None
            }
            [0xff, 0xfe, ..] => {
                self.start = 2;
                Some(UTF_16LE)
            }
            [0xfe, 0xff, ..] => {
                self.start = 2;
                Some(UTF_16BE)
            }
            _ if head.len() >= 8 => {
                let zeros = |odd: usize| head.iter().skip(odd).step_by(2).filter(|b| **b == 0).count();
                let half = head.len() / 2;
                if zeros(1) * 10 >= half * 9 && zeros(0) == 0 {
                    Some(UTF_16LE)
                } else if zeros(0) * 10 >= half * 9 && zeros(1) == 0 {
                    Some(UTF_16BE)
                } else {
                    None
                }
            }
            _ => None,
        };
        if let Some(encoding) = utf16 {
            let raw = self.buffer.split_off(self.start);
            let mut decoder = encoding.new_decoder_without_bom_handling();
            self.buffer.clear();
            self.start = 0;
            append(&mut decoder, &raw, self.finished, &mut self.buffer);
            self.decoder = Some(decoder);
            self.decoded = true;
        }
    }

    /// Reads until `least` bytes are held or the stream ends.
    fn fill(&mut self, least: usize) -> io::Result<()> {
        if self.buffer.len() - self.start >= least || self.finished {
            return Ok(());
        }
        self.buffer.drain(..self.start);
        self.start = 0;
        let mut raw = Vec::new();
        while self.buffer.len() < least && !self.finished {
            let want = least - self.buffer.len();
            if let Some(decoder) = &mut self.decoder {
                raw.clear();
                let got = (&mut self.inner).take(want as u64).read_to_end(&mut raw)?;
                self.read_so_far += got as u64;
                self.finished = got < want;
                append(decoder, &raw, self.finished, &mut self.buffer);
            } else {
                let got = (&mut self.inner).take(want as u64).read_to_end(&mut self.buffer)?;
                self.read_so_far += got as u64;
                self.finished = got < want;
            }
        }
        Ok(())
    }

    /// Calls `each` for every record that is left. Errors: those of the reader.
    pub fn each(&mut self, mut each: impl FnMut(&Record)) -> io::Result<()> {
        let (mut batch, mut scratch) = (Batch::default(), RecordScratch::default());
        while self.next_batch(&mut batch)? {
            batch.records(&mut scratch, &mut each);
        }
        Ok(())
    }

    /// Puts the next records into `batch`; `false` at the end of the stream. Errors: those of the reader.
    pub fn next_batch(&mut self, batch: &mut Batch) -> io::Result<bool> {
        if !self.skipping && self.decoder.is_none() && self.next_simple(batch)? {
            return Ok(true);
        }
        loop {
            self.fill(LOOKAHEAD + self.block)?;
            if self.skipping {
                self.skip_line()?;
                continue;
            }
            let (finished, shape) = (self.finished, self.shape);
            let data = &self.buffer[self.start..];
            if data.is_empty() {
                return Ok(false);
            }
            let mut cut = if finished && data.len() <= self.block {
                data.len()
            } else {
                memchr::memrchr(b'\n', &data[..data.len().min(self.block)]).map_or(0, |k| k + 1)
            };
            let simple = cut > 0 && is_simple(&data[..cut]);
            let mut lines = 0;
            if simple {
                lines = memchr::memchr_iter(b'\n', &data[..cut]).count() as u64;
            } else {
                cut = 0;
                while cut < data.len() && cut < self.block && (finished || data.len() - cut >= LOOKAHEAD) {
                    let plain = plain_lines(&data[cut..data.len().min(self.block)]);
                    if plain > 0 {
                        lines += memchr::memchr_iter(b'\n', &data[cut..cut + plain]).count() as u64;
                        cut += plain;
                        continue;
                    }
                    let Some(walked) = walk(data, cut, shape, finished, &mut |_| {}) else { break };
                    cut = walked.next;
                    lines += walked.lines;
                }
            }
            // no end within reach: one unreadable record, and the rest of its line is passed over
            self.skipping = cut == 0;
            let shown = if cut == 0 { data.len().min(4 * SHOWN) } else { cut };
            batch.bytes.clear();
            batch.bytes.extend_from_slice(&data[..shown]);
            self.tell(batch, simple, cut == 0);
            self.start += cut;
            self.line += lines;
            return Ok(true);
        }
    }

    /// Tells a batch what it is besides its bytes.
    fn tell(&mut self, batch: &mut Batch, simple: bool, overlong: bool) {
        *batch = Batch {
            bytes: std::mem::take(&mut batch.bytes),
            line: self.line,
            shape: self.shape,
            simple,
            overlong,
            decoded: self.decoded,
            read_so_far: self.read_so_far,
            number: self.batches,
        };
        self.batches += 1;
    }

    /// Reads straight into the batch up to a line end, where all that is read has neither quotes nor lone CRs. `false`:
    /// nothing is taken, the bytes are in the buffer.
    fn next_simple(&mut self, batch: &mut Batch) -> io::Result<bool> {
        let held = self.buffer.len() - self.start;
        if self.finished || held >= self.block {
            return Ok(false);
        }
        batch.bytes.clear();
        batch.bytes.extend_from_slice(&self.buffer[self.start..]);
        let want = self.block - held;
        let got = (&mut self.inner).take(want as u64).read_to_end(&mut batch.bytes)?;
        self.read_so_far += got as u64;
        self.finished = got < want;
        self.start = 0;
        let cut = memchr::memrchr(b'\n', &batch.bytes).map_or(0, |k| k + 1);
        let rest = &batch.bytes[cut..];
        // What is behind the last line end of the file is left to the careful way.
        if cut == 0 || (self.finished && !rest.is_empty()) || !is_simple(&batch.bytes[..cut]) {
            std::mem::swap(&mut self.buffer, &mut batch.bytes);
            return Ok(false);
        }
        self.buffer.clear();
        self.buffer.extend_from_slice(rest);
        batch.bytes.truncate(cut);
        self.tell(batch, true, false);
        self.line += memchr::memchr_iter(b'\n', &batch.bytes).count() as u64;
        Ok(true)
    }

    /// Passes over bytes up to and with the next line end.
    fn skip_line(&mut self) -> io::Result<()> {
        loop {
            let data = &self.buffer[self.start..];
            if let Some(at) = memchr::memchr2(b'\n', b'\r', data) {
                if let Some(next) = line_end(data, at, self.finished) {
                    self.start += next;
                    self.line += 1;
                    self.skipping = false;
                    return Ok(());
                }
                self.start += at;
            } else {
                self.start = self.buffer.len();
            }
            if self.finished {
                self.skipping = false;
                return Ok(());
            }
            self.fill(LOOKAHEAD)?;
        }
    }
}

/// What a file is by its first bytes, where it is something else than text in lines that people take for CSV.
fn foreign(head: &[u8]) -> Option<&'static str> {
    let has = |text: &str| memchr::memmem::find(head, text.as_bytes()).is_some();
    match head {
        [b'P', b'K', 3, 4, ..] | [b'P', b'K', 5, 6, ..] => Some(match () {
            () if has("opendocument.spreadsheet") => "a LibreOffice spreadsheet (.ods)",
            () if has("xl/") => "an Excel workbook (.xlsx)",
            () if has("Index/") => "a Numbers spreadsheet (.numbers)",
            () if has("[Content_Types].xml") => "an Office file, such as an Excel workbook (.xlsx)",
            () => "a zip archive",
        }),
        [0xd0, 0xcf, 0x11, 0xe0, ..] => Some("an old Excel workbook (.xls)"),
        [0x1f, 0x8b, 8, ..] => Some("a compressed file (.gz)"),
        [b'%', b'P', b'D', b'F', b'-', ..] => Some("a PDF file"),
        _ => {
            let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
            let begins =
                |mark: &str| text.get(..mark.len()).is_some_and(|t| t.eq_ignore_ascii_case(mark.as_bytes()));
            ["<!doctype", "<html", "<?xml", "<table"]
                .into_iter()
                .any(begins)
                .then_some("a web page or an XML file (some services export one as .xls)")
        }
    }
}

/// How many bytes at the start are whole lines without a quote or a lone CR, of the next few.
fn plain_lines(data: &[u8]) -> usize {
    // Not far: where each line has a lone CR, this is asked anew for each.
    const FAR: usize = 8 * 1024;
    let data = &data[..data.len().min(FAR)];
    let odd = memchr::memchr2_iter(b'"', b'\r', data)
        .find(|i| data[*i] == b'"' || data.get(i + 1) != Some(&b'\n'))
        .unwrap_or(data.len());
    memchr::memrchr(b'\n', &data[..odd]).map_or(0, |k| k + 1)
}

/// Neither a quote nor a lone CR.
fn is_simple(data: &[u8]) -> bool {
    memchr::memchr(b'"', data).is_none()
        && memchr::memchr_iter(b'\r', data).all(|i| data.get(i + 1) == Some(&b'\n'))
}

/// Decodes onto the end of `out`.
fn append(decoder: &mut encoding_rs::Decoder, raw: &[u8], last: bool, out: &mut Vec<u8>) {
    let mut text =
        String::with_capacity(decoder.max_utf8_buffer_length(raw.len()).unwrap_or(raw.len() * 3 + 16));
    let (_, _, _) = decoder.decode_to_string(raw, &mut text, last);
    out.extend_from_slice(text.as_bytes());
}

/// The delimiter that the header has most of, outside quotes; a comma if there is none.
fn sniff(head: &[u8]) -> u8 {
    let mut counts = [(b',', 0usize), (b';', 0), (b'\t', 0)];
    let mut quoted = false;
    for b in head.iter().take(FIELD_CAP) {
        match b {
            b'"' => quoted = !quoted,
            b'\n' | b'\r' if !quoted => break,
            b if !quoted => {
                if let Some((_, n)) = counts.iter_mut().find(|(c, _)| c == b) {
                    *n += 1;
                }
            }
            _ => {}
        }
    }
    counts.iter().rev().max_by_key(|(_, n)| *n).filter(|(_, n)| *n > 0).map_or(b',', |(c, _)| *c)
}

/// Records with their lines and fields.
pub type Lines = Vec<(u64, Vec<String>)>;

/// All records of some bytes, for small files and tests: (header, records with their lines and fields).
/// Errors: those of the reader.
pub fn all_records(inner: Box<dyn Read + Send>) -> io::Result<(Option<Header>, Lines)> {
    let (mut source, header) = RecordSource::open(inner)?;
    Ok((header, collect(&mut source)?))
}

fn collect(source: &mut RecordSource) -> io::Result<Lines> {
    let mut all = Vec::new();
    source.each(|r| {
        let fields = (0..r.len()).map(|i| String::from_utf8_lossy(r.get(i).unwrap_or_default()).into_owned());
        all.push((r.line, fields.collect()));
    })?;
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::io::Cursor;

    fn read_all(bytes: &[u8]) -> (Option<Header>, Vec<(u64, Vec<String>)>) {
        all_records(Box::new(Cursor::new(bytes.to_vec()))).unwrap()
    }
    fn lines(bytes: &[u8]) -> Vec<(u64, String)> {
        read_all(bytes).1.into_iter().map(|(l, f)| (l, f.join("|"))).collect()
    }
    fn rows(all: &[(u64, &str)]) -> Vec<(u64, String)> {
        all.iter().map(|(l, t)| (*l, (*t).to_owned())).collect()
    }

    #[test]
    fn line_ends_quotes_and_blank_lines() {
        let text = b"a,b\r\n1,\"x, \"\"y\"\"\"\r\n\r\n2,\"two\nlines\"\n3,5\" rod\r4, \"z\" ,\n5,\"q\" r";
        let want =
            rows(&[(2, "1|x, \"y\""), (4, "2|two\nlines"), (6, "3|5\" rod"), (7, "4|z|"), (8, "5|q r")]);
        assert_eq!(lines(text), want);
    }

    #[test]
    fn a_quote_left_open_is_a_character() {
        let text = b"a,b\n1,\"30.3\n2,4\n3,\"5\"\n";
        assert_eq!(lines(text), rows(&[(2, "1|\"30.3"), (3, "2|4"), (4, "3|5")]));
        let mut long = b"a,b\n1,\"30.3\n".to_vec();
        for i in 0..30_000 {
            long.extend_from_slice(format!("{i},x\n").as_bytes());
        }
        let got = lines(&long);
        assert_eq!(got.len(), 30_001);
        assert_eq!(got[0], (2, "1|\"30.3".to_owned()));
        assert_eq!(got[30_000], (30_002, "29999|x".to_owned()));
    }

    #[test]
    fn whole_records_are_not_swallowed_by_a_quote() {
        let text = b"a,b\n1,\"30.3\n2,4\n\n3,5\"\n4,\"two\nlines\"\n5,\"\nx,y\nz\"\n";
        let want = [(2, "1|\"30.3"), (3, "2|4"), (5, "3|5\""), (6, "4|two\nlines"), (8, "5|\nx,y\nz")];
        assert_eq!(lines(text), rows(&want));
    }

    #[test]
    fn encodings() {
        let text = "Student;Wert\nMüller;30 °\n";
        let want = rows(&[(2, "Müller|30 °")]);
        let utf16 = |big: bool, bom: bool| {
            let text = if bom { format!("\u{feff}{text}") } else { text.to_owned() };
            text.encode_utf16()
                .flat_map(|u| if big { u.to_be_bytes() } else { u.to_le_bytes() })
                .collect::<Vec<u8>>()
        };
        let (latin, _, _) = WINDOWS_1252.encode(text);
        let bom = [b"\xef\xbb\xbf", text.as_bytes()].concat();
        for bytes in [
            text.as_bytes().to_vec(),
            bom,
            latin.into_owned(),
            utf16(true, true),
            utf16(false, true),
            utf16(true, false),
            utf16(false, false),
        ] {
            let (header, _) = read_all(&bytes);
            assert_eq!(header.unwrap().fields, ["Student", "Wert"]);
            assert_eq!(lines(&bytes), want);
        }
    }

    #[test]
    fn delimiters_and_excels_first_line() {
        let (header, records) = read_all(b"sep=;\r\nstudent;answer\r\na;1,25\r\n");
        let header = header.unwrap();
        assert_eq!((header.line, header.delimiter), (2, b';'));
        assert_eq!(records, [(3, vec!["a".to_owned(), "1,25".to_owned()])]);
        assert_eq!(read_all(b"student\tanswer\na\t1\n").0.unwrap().delimiter, b'\t');
        assert_eq!(read_all(b"\n\n").0, None);
    }

    #[test]
    fn a_very_long_line_is_one_record() {
        let mut text = b"a,b\n1,2\n".to_vec();
        text.extend(std::iter::repeat_n(b'x', 3_000_000));
        text.extend_from_slice(b"\n3,4\n");
        let got = lines(&text);
        assert_eq!((got.len(), got[1].0, got[2].clone()), (3, 3, (4, "3|4".to_owned())));
    }

    proptest! {
        #[test]
        fn no_bytes_panic_and_blocks_do_not_matter(
            bytes in prop::collection::vec(prop_oneof![
                Just(b','), Just(b'"'), Just(b'\n'), Just(b'\r'), Just(b'a'), Just(b' '), any::<u8>()], 0..400),
            block in 16usize..200,
        ) {
            let bytes = [b"a,b\n".as_slice(), &bytes].concat();
            let (_, want) = read_all(&bytes);
            let (mut source, _) = RecordSource::with_block(Box::new(Cursor::new(bytes.clone())), block).unwrap();
            prop_assert_eq!(collect(&mut source).unwrap(), want);
        }
    }
}
