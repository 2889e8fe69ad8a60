//! A set is made: its folder whole or not at all, late joiners into one that is there, and repair of what a kill left.
use crate::answer::roster;
use crate::bank::{Bank, Problem};
use crate::csv_field::push_line;
use crate::draw::stream;
use crate::finding::{Finding, Findings};
use crate::folder::files::names_in;
use crate::folder::staged::Staged;
use crate::folder::{self, Progress, files, index, names, set};
use crate::inspect::table::unsatisfiable;
use crate::key::SheetKey;
use crate::set::coincide::StudentVariant;
use crate::set::dealer::{Dealer, Dealt};
use crate::set::store::{StoredBank, StoredSet, StoredStudent};
use crate::set::{coincide, dealer, key_file, replay, store};
use crate::sheet::html::Converter;
use crate::sheet::key_table::KeyTableRow;
use crate::sheet::output::{DocumentWriter, Format, WrittenDocument};
use crate::sheet::self_check::{self, Handed, Hosting, PROGRAM_NAME, SelfCheck, Use};
use crate::sheet::sheets::{SheetScratch, Sheets};
use crate::sheet::texts::Texts;
use crate::sheet::{key_table, public, terminal};
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// All that decides what is in a set.
pub struct Plan<'p> {
    pub bank: &'p Bank,
    pub text: &'p str,
    /// Templates and phrases.
    pub texts: &'p Texts,
    /// Formats of the sheets.
    pub formats: &'p [Format],
    /// Where the program of sheets that check themselves lies.
    pub hosting: Hosting,
    /// Problems, as indices.
    pub problems: &'p [usize],
    pub seed: u64,
    /// Name of the set.
    pub name: &'p str,
}

impl<'p> Plan<'p> {
    /// The problems, in the order of the sheet.
    pub fn chosen(&self) -> impl Iterator<Item = &'p Problem> + Clone {
        let (bank, problems) = (self.bank, self.problems);
        problems.iter().filter_map(|p| bank.problems.get(*p))
    }
    /// Is the program that checks beside the sheets, so that these go on a web server as a whole?
    pub fn has_program(&self) -> bool {
        let pages = self.formats.contains(&Format::Html) && self.bank.self_check;
        self.hosting == Hosting::Site && pages
    }
}

/// May a set have this name? Errors: it is no line of text.
pub fn may_be_named(name: &str) -> Result<(), Finding> {
    match name.trim().is_empty() || name.chars().any(char::is_control) {
        true => Err(Finding::new("--name", "the name of a set is a line of text")),
        false => Ok(()),
    }
}

/// The students of a roster file; nothing is drawn for them yet. Errors: all that is wrong with it.
pub fn members(path: &Path) -> Result<Vec<StoredStudent>, Findings> {
    let students = roster::roster(&files::read(path)?).map_err(|f| f.in_file(path.display().to_string()))?;
    let member = |(student, name): (String, String)| StoredStudent {
        folder: roster::folder(&student),
        student,
        name,
        problems: Vec::new(),
    };
    Ok(students.into_iter().map(member).collect())
}

/// What `generate` made, for the summary.
pub struct SetMade {
    /// The set as it is stored now.
    pub set: StoredSet,
    /// Students written in this run.
    pub written: usize,
    /// Draws that were refused, of all.
    pub tries: u64,
    /// Problems whose list of coincidences was cut.
    pub cut: Vec<String>,
}

impl SetMade {
    /// Pairs too much alike, in lines.
    pub fn coincidences(&self) -> String {
        let found = &self.set.coincidences;
        if found.is_empty() {
            const NONE: &str =
                "  no two students have an equal problem or all answers of a problem within tolerance";
            return NONE.to_owned();
        }
        let cut =
            if self.cut.is_empty() { String::new() } else { format!(" and more of {}", self.cut.join(", ")) };
        let mut text = format!(
            "  {}{cut} with an equal problem or all its answers within tolerance (all in set.json):",
            terminal::count(found.len(), "pair")
        );
        let pairs = found.iter().map(|c| {
            let [one, other] = &c.students;
            format!("{}: {one} and {other}, {}", c.problem, c.what)
        });
        for line in terminal::first_of(pairs, 8) {
            text.push_str(&format!("\n    {line}"));
        }
        text
    }
}

/// The folder of a new set, whole or not at all. Errors: what the bank or its texts refuse, or writing that fails.
pub fn whole(
    plan: &Plan,
    members: &[StoredStudent],
    out: &Path,
    progress: &dyn Progress,
) -> Result<SetMade, Findings> {
    let staged = Staged::new(out)?;
    let mut dealt = deal(plan, members, staged.path(), progress).map_err(|f| staged.named(f))?;
    let tries = dealt.tries();
    let (set, cut) = store(plan, std::mem::take(&mut dealt.students), &dealt.keys);
    for (name, bytes) in of_site(plan) {
        staged.write(&name, bytes)?;
    }
    staged.write(names::BANK, plan.text.as_bytes())?;
    let key = key_file::text(&dealt.keys);
    staged.write(names::KEY, &key)?;
    staged.write(names::FORM, &blank_form(plan, &set))?;
    for (name, bytes) in together(plan, &dealt.sheets, &dealt.rows, &dealt.keys)? {
        staged.write(name, &bytes)?;
    }
    staged.write(names::SET, set.sealed(&key).as_bytes())?;
    staged.finish()?;
    Ok(SetMade { written: members.len(), set, tries, cut })
}

/// What lies beside the sheets where they are put on a web server.
fn of_site(plan: &Plan) -> Vec<(String, &'static [u8])> {
    let program = (PROGRAM_NAME.as_str(), self_check::PROGRAM);
    let files = [program, (names::WORKER, self_check::WORKER.as_bytes())].into_iter();
    files
        .filter(|_| plan.has_program())
        .map(|(name, of)| (format!("{}/{name}", names::STUDENTS), of))
        .collect()
}

/// Booklets, the key for people, and the page to start from.
fn together(
    plan: &Plan,
    sheets: &[WrittenDocument],
    rows: &[KeyTableRow],
    keys: &[SheetKey],
) -> Result<Vec<(&'static str, Vec<u8>)>, Finding> {
    let output = DocumentWriter::new(plan.texts, plan.formats, "sheet")?;
    let title = format!("{}: {}, {}", plan.texts.words.get("sheet.sheets"), plan.bank.title, plan.name);
    let mut files = output.booklets(&title, sheets)?;
    files.extend(output.key_table(plan.bank, plan.name, plan.problems, rows, keys.iter())?);
    let made: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
    let students = sheets.iter().map(|s| (&s.head, roster::folder(&s.head.student)));
    let index = index::of_set(plan, students, &made)?;
    files.push((names::INDEX, index));
    Ok(files)
}

/// Booklets and the key for people of a stored set, from sheets written anew; nothing is put anywhere.
fn together_again(plan: &Plan, set: &StoredSet) -> Result<Vec<(&'static str, Vec<u8>)>, Findings> {
    let writer = SheetWriter::new(plan)?;
    let both = replay::each(plan.bank, set, &|i, student, dealt| {
        let mut converter = Converter::new(&plan.texts.words);
        let (sheet, row) = writer.write(i, student, &dealt, &mut SheetScratch::default(), &mut converter)?;
        Ok((sheet, row, dealt.key))
    })?;
    let (sheets, rows, keys): (Vec<_>, Vec<_>, Vec<_>) = both.into_iter().collect();
    Ok(together(plan, &sheets, &rows, &keys)?)
}

/// Late joiners into a set that is there. All is written beside the set and then moved in: sheets, key.csv, set.json,
/// the form, booklets and the key for people. A run that is killed before set.json leaves the old set, with sheets of
/// students whom it does not know and rows of theirs in key.csv, which grading passes over; killed after it, the new set
/// with an old form or booklet. The next `--add` [`repair`]s either, and `--force` replaces it. Errors: what the bank or its
/// texts refuse, or writing that fails.
pub fn add(
    plan: &Plan,
    members: &[StoredStudent],
    old: &StoredSet,
    out: &Path,
    progress: &dyn Progress,
) -> Result<SetMade, Findings> {
    let mut keys = replay::keys(plan.bank, old)?;
    let places = || members.iter().map(|m| Path::new(names::STUDENTS).join(&m.folder));
    let taken = |place: &PathBuf| {
        Finding::of_file(place, "is there already, and generate did not make it").hint("move it away")
    };
    let taken: Findings = places().map(|p| out.join(p)).filter(|p| p.exists()).map(|p| taken(&p)).collect();
    taken.into_result(())?;
    let staged = Staged::new(out)?;
    let dealt = deal(plan, members, staged.path(), progress).map_err(|f| staged.named(f))?;
    let (tries, form_is_blank) = (dealt.tries(), set::form_is_blank(out));
    keys.extend(dealt.keys);
    let (set, cut) = store(plan, old.students.iter().cloned().chain(dealt.students).collect(), &keys);
    let key = key_file::text(&keys);
    let sealed = set.sealed(&key).into_bytes();
    let mut files = vec![(names::KEY, key), (names::SET, sealed)];
    if form_is_blank {
        files.push((names::FORM, blank_form(plan, &set)));
    }
    files.extend(together_again(plan, &set)?);
    for (name, bytes) in &files {
        staged.write(name, bytes)?;
    }
    let site = of_site(plan);
    for (name, bytes) in &site {
        staged.write(name, bytes)?;
    }
    let site = site.iter().map(|(name, _)| PathBuf::from(name));
    for name in site.chain(places()).chain(files.iter().map(|(name, _)| PathBuf::from(name))) {
        staged.place_one(&name)?;
    }
    Ok(SetMade { written: members.len(), set, tries, cut })
}

/// Makes good what an `--add` that was killed left in a set: sheets and rows of the key of students whom the set does
/// not know, and a form and booklets that lack the last ones. Booklets only where no others come (`last`). Errors: the set cannot
/// be replayed, or writing that fails.
pub fn repair(plan: &Plan, set: &StoredSet, out: &Path, last: bool) -> Result<(), Findings> {
    let folders: rustc_hash::FxHashSet<&str> = set.students.iter().map(|s| s.folder.as_str()).collect();
    let students = out.join(names::STUDENTS);
    for name in names_in(&students) {
        if !folders.contains(name.as_str()) && set::is_left_over(&students.join(&name), &name, set) {
            let path = students.join(&name);
            fs::remove_dir_all(&path).map_err(files::trouble(&path, "cannot be removed"))?;
        }
    }
    let keys = replay::keys(plan.bank, set)?;
    let stored = files::read(&out.join(names::KEY))?;
    let key = key_file::text(&keys);
    let form = blank_form(plan, set);
    let mut stale = Vec::new();
    // A key that somebody changed is not ours to mend: grading will say so.
    if !key_file::is_of(&stored, &keys) && key_file::compare(&stored, &keys).is_empty() {
        // One that an earlier version wrote comes back with codes, so that the set has another hash of it.
        stale.extend([(names::SET, set.sealed(&key).into_bytes()), (names::KEY, key)]);
    }
    if set::form_is_blank(out) && files::read(&out.join(names::FORM)).is_ok_and(|f| f != form) {
        stale.push((names::FORM, form));
    }
    if last {
        let anew = together_again(plan, set)?;
        stale.extend(
            anew.into_iter().filter(|(n, bytes)| files::read(&out.join(n)).ok().as_ref() != Some(bytes)),
        );
    }
    if stale.is_empty() {
        return Ok(());
    }
    let staged = Staged::new(out)?;
    for (name, bytes) in &stale {
        staged.write(name, bytes)?;
        staged.place_one(Path::new(name))?;
    }
    Ok(())
}

/// Writes sheets, one after the other, from what was dealt.
struct SheetWriter<'p> {
    plan: &'p Plan<'p>,
    sheets: Sheets<'p>,
    output: DocumentWriter<'p>,
    public: public::Writer<'p>,
    /// `None` where the bank, or a page of somebody's own, leaves it out.
    self_check: Option<SelfCheck<'p>>,
}

impl<'p> SheetWriter<'p> {
    fn new(plan: &'p Plan<'p>) -> Result<Self, Findings> {
        let Texts { templates, words, .. } = plan.texts;
        let sheets = Sheets::new(templates, words, plan.bank, plan.name, plan.problems)?;
        let output = DocumentWriter::new(plan.texts, plan.formats, "sheet")?;
        let public = public::Writer::new(plan.bank, plan.text, plan.problems, plan.name, words.language())?;
        let checks = plan.bank.self_check && templates.variables("sheet.html")?.iter().any(|v| v == "check");
        let self_check = checks.then(|| SelfCheck::new(words, plan.hosting, Use::Sheet));
        Ok(Self { plan, sheets, output, public, self_check })
    }

    fn write(
        &self,
        at: usize,
        student: &StoredStudent,
        dealt: &Dealt,
        scratch: &mut SheetScratch,
        converter: &mut Converter,
    ) -> Result<(WrittenDocument, KeyTableRow), Finding> {
        let Plan { bank, problems, .. } = self.plan;
        let variants = &dealt.variants;
        let (head, document) = self.sheets.document(&student.student, &student.name, variants, scratch)?;
        let row = key_table::row(bank, problems, &head, variants);
        let sheet = self.public.text(&student.student, variants);
        let handed = Handed { head: &head, folder: &student.folder, sheet: &sheet, variants };
        let tools = self.self_check.as_ref().map(|check| check.tools(bank, problems, &handed)).transpose()?;
        let mut made = self.output.make(at, head, document, converter, tools.as_ref())?;
        made.files.push((names::SHEET.to_owned(), sheet.into_bytes()));
        Ok((made, row))
    }
}

/// What was dealt to students, in their order.
#[derive(Default)]
struct DealtToAll {
    students: Vec<StoredStudent>,
    keys: Vec<SheetKey>,
    sheets: Vec<WrittenDocument>,
    rows: Vec<KeyTableRow>,
}

impl DealtToAll {
    fn tries(&self) -> u64 {
        self.students.iter().flat_map(|s| &s.problems).map(|p| u64::from(p.tries)).sum()
    }
}

/// Draws, solves and writes the sheets of these students into `students` below `folder`.
fn deal(
    plan: &Plan,
    members: &[StoredStudent],
    folder: &Path,
    progress: &dyn Progress,
) -> Result<DealtToAll, Findings> {
    // Of the whole folder: a full disk is told once and not for each student.
    let fault = files::trouble(folder, "cannot be written");
    fs::create_dir(folder.join(names::STUDENTS)).map_err(fault)?;
    let writer = SheetWriter::new(plan)?;
    let dealer = Dealer::new(plan.bank, plan.problems, plan.seed, plan.name);
    let results: Vec<Result<(StoredStudent, SheetKey, WrittenDocument, KeyTableRow), Finding>> = members
        .par_iter()
        .enumerate()
        .map_init(
            || (SheetScratch::default(), Converter::new(&plan.texts.words)),
            |(scratch, converter), (at, member)| {
                let dealt = dealer.deal(&member.student).map_err(|none| unsatisfiable(plan.bank, &none))?;
                let (mut made, row) = writer.write(at, member, &dealt, scratch, converter)?;
                let place = folder.join(names::STUDENTS).join(&member.folder);
                fs::create_dir(&place).map_err(fault)?;
                for (name, bytes) in made.files.drain(..) {
                    fs::write(place.join(name), bytes).map_err(fault)?;
                }
                progress.advance("sheets", 1, members.len() as u64);
                let variants = plan.chosen().zip(&dealt.variants).map(|(p, v)| dealer::stored(p, v));
                Ok((StoredStudent { problems: variants.collect(), ..member.clone() }, dealt.key, made, row))
            },
        )
        .collect();
    let (mut handed, mut faults) = (DealtToAll::default(), Findings::default());
    for result in results {
        match result {
            Ok((student, key, sheet, row)) => {
                handed.students.push(student);
                handed.keys.push(key);
                handed.sheets.push(sheet);
                handed.rows.push(row);
            }
            Err(fault) if faults.contains(&fault) || faults.len() >= 5 => {}
            Err(fault) => faults.push(fault),
        }
    }
    faults.into_result(handed)
}

/// set.json of these students with their keys, and the problems of which not all coincidences are listed.
fn store(plan: &Plan, students: Vec<StoredStudent>, keys: &[SheetKey]) -> (StoredSet, Vec<String>) {
    let mut coincidences = Vec::new();
    let mut cut = Vec::new();
    for (i, problem) in plan.chosen().enumerate() {
        let data = |s: &StoredStudent| -> Vec<String> {
            let drawn = s.problems.get(i).into_iter().flat_map(|p| &p.data);
            drawn.map(|(k, v)| format!("{k}={v}")).collect()
        };
        let texts: Vec<Vec<String>> = students.iter().map(data).collect();
        let variants: Vec<StudentVariant> = students
            .iter()
            .zip(&texts)
            .zip(keys)
            .filter_map(|((s, data), k)| {
                Some(StudentVariant { student: &s.student, data, key: k.problems.get(i)? })
            })
            .collect();
        let (pairs, more) = coincide::pairs(&problem.id, &variants);
        coincidences.extend(pairs);
        cut.extend(more.then(|| problem.id.clone()));
    }
    let bank =
        StoredBank { id: plan.bank.id.clone(), file: names::BANK.to_owned(), sha256: plan.bank.hash.clone() };
    let set = StoredSet {
        format: store::FORMAT,
        name: plan.name.to_owned(),
        seed: plan.seed,
        program: folder::program(),
        draw_version: stream::DRAW_VERSION,
        language: plan.texts.words.language().to_owned(),
        formats: plan.formats.iter().map(|f| f.as_str().to_owned()).collect(),
        page: plan.hosting,
        bank,
        key_sha256: None,
        problems: plan.chosen().map(|p| p.id.clone()).collect(),
        students,
        coincidences,
    };
    (set, cut)
}

/// A form to fill in: long, no answers.
fn blank_form(plan: &Plan, set: &StoredSet) -> Vec<u8> {
    let mut out = b"student,problem,part,answer\n".to_vec();
    for student in &set.students {
        for (i, problem) in plan.chosen().enumerate() {
            for q in &problem.questions {
                push_line(&mut out, [student.student.as_str(), &(i + 1).to_string(), &q.id, ""]);
            }
        }
    }
    out
}
