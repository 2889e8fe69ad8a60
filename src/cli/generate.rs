//! `slipstick generate`: bank and roster to a folder with a sheet for each student.
use crate::answer::roster;
use crate::bank::Bank;
use crate::cli::args;
use crate::cli::args::Format;
use crate::cli::banks;
use crate::cli::banks::Texts;
use crate::cli::files;
use crate::cli::files::Staged;
use crate::cli::lint;
use crate::cli::output;
use crate::cli::output::Made;
use crate::cli::output::Output;
use crate::cli::solve;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::tell::count;
use crate::draw::stream;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::guard::push_line;
use crate::key::SheetKey;
use crate::set::coincide;
use crate::set::key_file;
use crate::set::replay;
use crate::set::replay::Dealer;
use crate::set::replay::Dealt;
use crate::set::store;
use crate::set::store::StoredBank;
use crate::set::store::StoredSet;
use crate::set::store::StoredStudent;
use crate::sheet::html::Converter;
use crate::sheet::key_table;
use crate::sheet::key_table::Row;
use crate::sheet::page::Room;
use crate::sheet::page::Sheets;
use crate::sheet::public;
use crate::sheet::public::SheetFile;
use rayon::prelude::*;
use std::fs;
use std::path::Path;

/// Files of a set beside the folder `students`, its booklets and its key for people.
pub const OF_SET: [&str; 4] = ["bank.yaml", "key.csv", "set.json", "submissions.csv"];

/// Is this the name of a file that a student gets? Sheets in any format, and the figures of a set with this many problems.
fn of_student(name: &str, problems: usize) -> bool {
    let sheet = name.strip_prefix("sheet.");
    let figure = name.strip_prefix("problem-").and_then(|n| n.strip_suffix(".svg"));
    sheet.is_some_and(|e| e == "json" || Format::ALL.iter().any(|f| f.ending() == e))
        || figure.is_some_and(|n| (1..=problems).any(|i| i.to_string() == n))
}

/// A student of the roster.
pub struct Member {
    /// Id.
    pub student: String,
    /// Name, or empty.
    pub name: String,
    /// Folder.
    pub folder: String,
}

/// All that decides what is in a set.
pub struct Plan<'p> {
    /// The bank.
    pub bank: &'p Bank,
    /// Its text.
    pub text: &'p str,
    /// Templates and phrases.
    pub texts: &'p Texts,
    /// Formats of the sheets.
    pub formats: &'p [Format],
    /// Problems, as indices.
    pub problems: &'p [usize],
    /// Seed.
    pub seed: u64,
    /// Name of the set.
    pub name: &'p str,
}

/// Runs it.
pub fn run(args: &args::Generate, io: &mut Io) -> Exit {
    let work = |io: &mut Io| match generate(args, io) {
        Ok(()) => Exit::Fine,
        Err(findings) => io.findings(&findings),
    };
    work(io)
}

fn generate(args: &args::Generate, io: &mut Io) -> Result<(), Findings> {
    let mut faults = Findings::default();
    // First of all: a set that a killed run had moved aside goes back.
    files::sweep_beside(&args.out);
    let loaded = banks::load(&args.bank).map_err(|f| faults.extend(f)).ok();
    let members = members(&args.roster).map_err(|f| faults.extend(f)).ok();
    let (Some(mut loaded), Some(mut members)) = (loaded, members) else { return Err(faults) };
    let old = if args.add { Some(existing(&args.out)?) } else { None };
    let language = match (&args.own.language, &old) {
        (Some(language), _) => language.clone(),
        (None, Some(set)) => set.language.clone(),
        (None, None) => "en".to_owned(),
    };
    let texts = banks::texts(&args.own, &language, &mut loaded.bank)?;
    let formats = match (&args.format, &old) {
        (None, Some(set)) => output::stored(&set.formats),
        (asked, _) => output::formats(asked.as_deref()),
    };
    // A name that is not known is told with its place when the sheet is written.
    if banks::unknown_names(&loaded.bank, &texts.templates).is_empty() {
        let lacking = banks::never_given(&loaded.bank, &texts.templates);
        if !lacking.is_empty() {
            return Err(lacking);
        }
    }
    if old.is_none() {
        files::has_a_name(&args.out, "--out week-5")?;
        files::not_among_students(&args.out)?;
        may_write(&args.out, args.force)?;
    }
    let name = match (&args.name, &old) {
        (Some(name), _) => name.clone(),
        (None, Some(set)) => set.name.clone(),
        (None, None) => loaded.bank.id.clone(),
    };
    if name.trim().is_empty() || name.chars().any(char::is_control) {
        return Err(Finding::new("--name", "the name of a set is a line of text").into());
    }
    let problems = match (&args.problems, &old) {
        (Some(ids), _) => replay::indices(&loaded.bank, ids, "--problems")?,
        (None, Some(set)) => replay::indices(&loaded.bank, &set.problems, "problems")?,
        (None, None) => (0..loaded.bank.problems.len()).collect(),
    };
    // What a text of one's own gets wrong in a formula, students would see as raw commands.
    let tried = lint::tried(&loaded.bank, &texts, &problems)?;
    if !tried.faults.is_empty() {
        return Err(tried.faults);
    }
    // What only the worked solutions will lack is told now, as `lint` does, and refuses nothing.
    for fault in &tried.unsolved {
        io.note(&format!("note: {fault}"));
    }
    for note in &tried.notes {
        io.note(&format!("note: problems.{}: {}", note.problem, note.what));
    }
    let seed = args.seed.or(old.as_ref().map(|s| s.seed)).unwrap_or(0);
    let plan = Plan {
        bank: &loaded.bank,
        text: &loaded.text,
        texts: &texts,
        formats: &formats,
        problems: &problems,
        seed,
        name: &name,
    };
    if let Some(set) = &old {
        same_set(&plan, set, &args.out)?;
        let known: rustc_hash::FxHashSet<&str> = set.students.iter().map(|s| s.student.as_str()).collect();
        members.retain(|m| !known.contains(m.student.as_str()));
        repair(&plan, set, &args.out, members.is_empty())?;
        if members.is_empty() {
            io.line("Nobody to add: every student of the roster has a sheet already.");
            return Ok(());
        }
    }
    let pool = output::pool(args.threads)?;
    let watched = io.watched;
    let summary = pool.install(|| match &old {
        Some(set) => add(&plan, &members, set, &args.out, watched),
        None => whole(&plan, &members, &args.out, watched),
    })?;
    tell(&plan, &summary, &args.out, io);
    for note in lint::seldom_words(&loaded.bank, &problems) {
        io.line(&format!("  note: {}: {}", note.field, note.message));
    }
    for m in members.iter().filter(|m| m.folder != m.student) {
        io.line(&format!("  {} is in students/{}", m.student, m.folder));
    }
    Ok(())
}

/// The students of a roster file.
pub fn members(path: &Path) -> Result<Vec<Member>, Findings> {
    let bytes = files::read(path)?;
    let file = path.display().to_string();
    let students = roster::roster(&bytes).map_err(|faults| faults.in_file(file))?;
    let member =
        |(student, name): (String, String)| Member { folder: roster::folder(&student), student, name };
    Ok(students.into_iter().map(member).collect())
}

/// What `generate` made, for the summary.
pub struct Summary {
    /// The set as it is stored now.
    pub set: StoredSet,
    /// Students written in this run.
    pub written: usize,
    /// Draws that were refused, of all.
    pub tries: u64,
    /// Problems whose list of coincidences was cut.
    pub cut: Vec<String>,
}

/// The folder of a new set, whole or not at all.
pub fn whole(plan: &Plan, members: &[Member], out: &Path, watched: bool) -> Result<Summary, Findings> {
    let staged = Staged::new(out)?;
    let (dealt, sheets) = deal(plan, members, staged.path(), watched).map_err(|f| staged.named(f))?;
    let (set, cut) = store(plan, members, &dealt, None);
    let keys: Vec<SheetKey> = dealt.into_iter().map(|d| d.key).collect();
    let write = |name: &str, bytes: &[u8]| {
        fs::write(staged.path().join(name), bytes)
            .map_err(|e| files::trouble(&out.join(name), "cannot be written", &e))
    };
    write("bank.yaml", plan.text.as_bytes())?;
    let key = key_file::text(&keys);
    write("key.csv", &key)?;
    write("submissions.csv", &blank_form(plan, &set))?;
    for (name, bytes) in together(plan, &sheets, &keys)? {
        write(name, &bytes)?;
    }
    write("set.json", set.sealed(&key).as_bytes())?;
    staged.finish()?;
    let tries = tries(&set, 0);
    Ok(Summary { written: members.len(), set, tries, cut })
}

fn tries(set: &StoredSet, from: usize) -> u64 {
    set.students.iter().skip(from).flat_map(|s| &s.problems).map(|p| u64::from(p.tries)).sum()
}

/// Sheets of everybody: what the booklets and the key for people are made of.
struct Written {
    made: Vec<Made>,
    rows: Vec<Row>,
}

/// Booklets and the key for people.
fn together(
    plan: &Plan,
    sheets: &Written,
    keys: &[SheetKey],
) -> Result<Vec<(&'static str, Vec<u8>)>, Findings> {
    let output = Output::new(plan.texts, plan.formats, "sheet")?;
    let title = format!("{}: {}, {}", plan.texts.words.get("sheet.sheets"), plan.bank.title, plan.name);
    let mut files = output.booklets(&title, &sheets.made)?;
    let table = output.key_table(plan.bank, plan.name, plan.problems, &sheets.rows, keys.iter());
    files.extend(table?);
    Ok(files)
}

/// Booklets and the key for people of a stored set, from sheets written anew; nothing is put anywhere.
fn together_again(plan: &Plan, set: &StoredSet) -> Result<Vec<(&'static str, Vec<u8>)>, Findings> {
    let writer = SheetWriter::new(plan)?;
    let both = replay::each(plan.bank, set, &|i, student, dealt| {
        let mut converter = Converter::new(&plan.texts.words);
        let (made, row) =
            writer.write(i, &student.student, &student.name, &dealt, &mut Room::default(), &mut converter)?;
        Ok(((made, row), dealt.key))
    })?;
    let (sheets, keys): (Vec<(Made, Row)>, Vec<SheetKey>) = both.into_iter().unzip();
    let (made, rows) = sheets.into_iter().unzip();
    together(plan, &Written { made, rows }, &keys)
}

/// Late joiners into a set that is there. All is written beside the set and then moved in: sheets, key.csv, set.json,
/// the form, booklets and the key for people. A run that is killed before set.json leaves the old set, with sheets of
/// students whom it does not know and rows of theirs in key.csv, which grading passes over; killed after it, the new set
/// with an old form or booklet. The next `--add` [`repair`]s either, and `--force` replaces it.
fn add(
    plan: &Plan,
    members: &[Member],
    old: &StoredSet,
    out: &Path,
    watched: bool,
) -> Result<Summary, Findings> {
    let mut keys = replay::keys(plan.bank, old)?;
    let taken: Findings = members
        .iter()
        .map(|m| out.join("students").join(&m.folder))
        .filter(|p| p.exists())
        .map(|p| {
            let fault = Finding::new("", "is there already, and generate did not make it");
            fault.in_file(p.display().to_string()).hint("move it away")
        })
        .collect();
    if !taken.is_empty() {
        return Err(taken);
    }
    let staged = Staged::new(out)?;
    let (dealt, _) = deal(plan, members, staged.path(), watched).map_err(|f| staged.named(f))?;
    let mut everybody: Vec<Member> = old
        .students
        .iter()
        .map(|s| Member { student: s.student.clone(), name: s.name.clone(), folder: s.folder.clone() })
        .collect();
    let before = everybody.len();
    let form_is_blank = form_is_blank(out);
    everybody.extend(members.iter().map(|m| Member {
        student: m.student.clone(),
        name: m.name.clone(),
        folder: m.folder.clone(),
    }));
    keys.extend(dealt.iter().map(|d| d.key.clone()));
    let (set, cut) = store(plan, &everybody, &dealt, Some((old, &keys)));
    let key = key_file::text(&keys);
    let sealed = set.sealed(&key).into_bytes();
    let mut files = vec![("key.csv", key), ("set.json", sealed)];
    if form_is_blank {
        files.push(("submissions.csv", blank_form(plan, &set)));
    }
    files.extend(together_again(plan, &set)?);
    for (name, bytes) in &files {
        fs::write(staged.path().join(name), bytes)
            .map_err(|e| files::trouble(&out.join(name), "cannot be written", &e))?;
    }
    let sheets = members.iter().map(|m| Path::new("students").join(&m.folder));
    for name in sheets.chain(files.iter().map(|(name, _)| Path::new(name).to_owned())) {
        staged.place_one(&name)?;
    }
    let tries = tries(&set, before);
    Ok(Summary { written: members.len(), set, tries, cut })
}

/// Makes good what an `--add` that was killed left in a set: sheets and rows of the key of students whom the set does
/// not know, and a form and booklets that lack the last ones. Booklets only where no others come (`last`).
fn repair(plan: &Plan, set: &StoredSet, out: &Path, last: bool) -> Result<(), Findings> {
    let folders: rustc_hash::FxHashSet<&str> = set.students.iter().map(|s| s.folder.as_str()).collect();
    let students = out.join("students");
    for name in files::names_in(&students) {
        if !folders.contains(name.as_str()) && is_left_over(&students.join(&name), &name, set) {
            let path = students.join(&name);
            fs::remove_dir_all(&path).map_err(|e| files::trouble(&path, "cannot be removed", &e))?;
        }
    }
    let keys = replay::keys(plan.bank, set)?;
    let stored = files::read(&out.join("key.csv"))?;
    let key = key_file::text(&keys);
    let form = blank_form(plan, set);
    let mut stale = Vec::new();
    // A key that somebody changed is not ours to mend: grading will say so.
    if stored != key && key_file::compare(&stored, &keys).is_empty() {
        stale.push(("key.csv", key));
    }
    if form_is_blank(out) && files::read(&out.join("submissions.csv")).is_ok_and(|f| f != form) {
        stale.push(("submissions.csv", form));
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
        fs::write(staged.path().join(name), bytes)
            .map_err(|e| files::trouble(&out.join(name), "cannot be written", &e))?;
        staged.place_one(Path::new(name))?;
    }
    Ok(())
}

/// Is this a student's folder that an `--add` to this set made and did not enter? It holds a sheet of this set and
/// nothing else, under the name that the sheet's student would have, who is not in the set.
fn is_left_over(folder: &Path, name: &str, set: &StoredSet) -> bool {
    let inside = files::names_in(folder);
    let exactly = inside.iter().all(|n| of_student(n, set.problems.len()));
    let sheet = || SheetFile::parse(&files::read_text(&folder.join("sheet.json")).ok()?).ok();
    exactly
        && sheet().is_some_and(|sheet| {
            sheet.set == set.name
                && roster::folder(&sheet.student) == name
                && set.students.iter().all(|s| s.student != sheet.student)
        })
}

/// Has nobody written into the form?
fn form_is_blank(out: &Path) -> bool {
    files::read(&out.join("submissions.csv")).is_ok_and(|form| !is_filled(&form))
}

fn is_filled(form: &[u8]) -> bool {
    String::from_utf8_lossy(form).lines().skip(1).any(|l| !l.ends_with(',') && !l.trim().is_empty())
}

/// Writes sheets, one after the other, from what was dealt.
struct SheetWriter<'p> {
    plan: &'p Plan<'p>,
    sheets: Sheets<'p>,
    output: Output<'p>,
}

impl<'p> SheetWriter<'p> {
    fn new(plan: &'p Plan<'p>) -> Result<Self, Findings> {
        let Texts { templates, words, .. } = plan.texts;
        let sheets = Sheets::new(templates, words, plan.bank, plan.name, plan.problems)?;
        Ok(Self { plan, sheets, output: Output::new(plan.texts, plan.formats, "sheet")? })
    }

    fn write(
        &self,
        at: usize,
        student: &str,
        name: &str,
        dealt: &Dealt,
        room: &mut Room,
        converter: &mut Converter,
    ) -> Result<(Made, Row), Finding> {
        let (head, document) = self.sheets.document(student, name, &dealt.variants, room)?;
        let row = key_table::row(self.plan.bank, self.plan.problems, &head, &dealt.variants);
        Ok((self.output.make(at, head, document, converter)?, row))
    }
}

/// Draws, solves and writes the sheets of these students into `students` below `folder`.
fn deal(
    plan: &Plan,
    members: &[Member],
    folder: &Path,
    watched: bool,
) -> Result<(Vec<Dealt>, Written), Findings> {
    fs::create_dir(folder.join("students")).map_err(|e| files::trouble(folder, "cannot be written", &e))?;
    let writer = SheetWriter::new(plan)?;
    let language = plan.texts.words.language();
    let public = public::Writer::new(plan.bank, plan.text, plan.problems, plan.name, language);
    let public = public?;
    let dealer = Dealer::new(plan.bank, plan.problems, plan.seed, plan.name);
    let bar = files::progress(watched, members.len() as u64, "sheets");
    let results: Vec<Result<(Dealt, Made, Row), Finding>> = members
        .par_iter()
        .enumerate()
        .map_init(
            || (Room::default(), Converter::new(&plan.texts.words)),
            |(room, converter), (at, member)| {
                let dealt =
                    dealer.deal(&member.student).map_err(|none| solve::unsatisfiable(plan.bank, &none))?;
                let (mut made, row) =
                    writer.write(at, &member.student, &member.name, &dealt, room, converter)?;
                let json = public.text(&member.student, &dealt.variants);
                let place = folder.join("students").join(&member.folder);
                // Of the whole folder: a full disk is told once and not for each student.
                let fault = |e: &std::io::Error| files::trouble(folder, "cannot be written", e);
                fs::create_dir(&place).map_err(|e| fault(&e))?;
                for (name, bytes) in made.files.drain(..) {
                    fs::write(place.join(name), bytes).map_err(|e| fault(&e))?;
                }
                fs::write(place.join("sheet.json"), json).map_err(|e| fault(&e))?;
                bar.inc(1);
                Ok((dealt, made, row))
            },
        )
        .collect();
    bar.finish_and_clear();
    let mut dealt = Vec::with_capacity(results.len());
    let mut sheets =
        Written { made: Vec::with_capacity(results.len()), rows: Vec::with_capacity(results.len()) };
    let mut faults = Findings::default();
    for result in results {
        match result {
            Ok((one, made, row)) => {
                dealt.push(one);
                sheets.made.push(made);
                sheets.rows.push(row);
            }
            Err(fault) if faults.contains(&fault) || faults.len() >= 5 => {}
            Err(fault) => faults.push(fault),
        }
    }
    faults.into_result((dealt, sheets))
}

/// set.json of everybody; `dealt` are the last of `members`, those before them come from the old set.
fn store(
    plan: &Plan,
    members: &[Member],
    dealt: &[Dealt],
    old: Option<(&StoredSet, &[SheetKey])>,
) -> (StoredSet, Vec<String>) {
    let before = members.len() - dealt.len();
    let mut students: Vec<StoredStudent> = old.map_or_else(Vec::new, |(set, _)| set.students.clone());
    for (member, dealt) in members[before..].iter().zip(dealt) {
        let chosen = plan.problems.iter().filter_map(|p| plan.bank.problems.get(*p));
        students.push(StoredStudent {
            student: member.student.clone(),
            name: member.name.clone(),
            folder: member.folder.clone(),
            problems: chosen.zip(&dealt.variants).map(|(p, v)| replay::stored(p, v)).collect(),
        });
    }
    let mut coincidences = Vec::new();
    let mut cut = Vec::new();
    let mut texts: Vec<Vec<String>> = Vec::new();
    for (i, problem) in plan.problems.iter().filter_map(|p| plan.bank.problems.get(*p)).enumerate() {
        texts.clear();
        texts.extend(students.iter().map(|s| {
            let data = s.problems.get(i).map(|p| &p.data);
            data.map_or_else(Vec::new, |d| d.iter().map(|(k, v)| format!("{k}={v}")).collect())
        }));
        let keys: Vec<&SheetKey> = match old {
            Some((_, keys)) => keys.iter().collect(),
            None => dealt.iter().map(|d| &d.key).collect(),
        };
        let variants: Vec<coincide::Variant> = students
            .iter()
            .zip(&texts)
            .zip(keys)
            .filter_map(|((s, data), k)| {
                Some(coincide::Variant { student: &s.student, data, key: k.problems.get(i)? })
            })
            .collect();
        let (pairs, more) = coincide::pairs(&problem.id, &variants);
        coincidences.extend(pairs);
        if more {
            cut.push(problem.id.clone());
        }
    }
    let set = StoredSet {
        format: store::FORMAT,
        name: plan.name.to_owned(),
        seed: plan.seed,
        program: tell::program(),
        draw_version: stream::DRAW_VERSION,
        language: plan.texts.words.language().to_owned(),
        formats: plan.formats.iter().map(|f| f.ending().to_owned()).collect(),
        bank: StoredBank {
            id: plan.bank.id.clone(),
            file: "bank.yaml".to_owned(),
            sha256: plan.bank.hash.clone(),
        },
        problems: plan
            .problems
            .iter()
            .filter_map(|p| plan.bank.problems.get(*p))
            .map(|p| p.id.clone())
            .collect(),
        students,
        coincidences,
    };
    (set, cut)
}

/// A form to fill in: long, no answers.
fn blank_form(plan: &Plan, set: &StoredSet) -> Vec<u8> {
    let mut out = b"student,problem,part,answer\n".to_vec();
    for student in &set.students {
        for (i, problem) in plan.problems.iter().filter_map(|p| plan.bank.problems.get(*p)).enumerate() {
            for q in &problem.questions {
                push_line(&mut out, [student.student.as_str(), &(i + 1).to_string(), &q.id, ""]);
            }
        }
    }
    out
}

/// The set that stands in a folder.
pub fn existing(folder: &Path) -> Result<StoredSet, Findings> {
    let path = folder.join("set.json");
    if folder.is_file() {
        let fault = Finding::new("", "is a file; a set is a folder").in_file(folder.display().to_string());
        return Err(fault.hint("give the folder that `slipstick generate` made").into());
    }
    if !path.is_file() {
        let fault = Finding::new("", "holds no set").in_file(folder.display().to_string());
        return Err(fault
            .hint("a set is a folder that `slipstick generate` made; it has a file set.json")
            .into());
    }
    let text = files::read_text(&path)?;
    StoredSet::parse(&text).map_err(|f| f.in_file(path.display().to_string()).into())
}

/// May a set be written here? Nothing, an empty folder, or with `--force` a set and nothing else.
fn may_write(out: &Path, force: bool) -> Result<(), Findings> {
    let finding = |what: &str| Finding::new("", what.to_owned()).in_file(out.display().to_string());
    if !out.exists() || (out.is_dir() && files::names_in(out).is_empty()) {
        return Ok(());
    }
    if !out.is_dir() {
        return Err(finding("is a file; a set is a folder").into());
    }
    if !force {
        let hint = "give another --out, or --force to replace a set, or --add for late joiners";
        return Err(finding("is there already").hint(hint).into());
    }
    if !out.join("set.json").is_file() {
        return Err(finding("holds no set").hint("--force replaces only what generate made").into());
    }
    let set = existing(out)?;
    let foreign = foreign(out, &set);
    if foreign.is_empty() {
        return Ok(());
    }
    let mut names = foreign.iter().take(5).cloned().collect::<Vec<_>>().join(", ");
    if foreign.len() > 5 {
        names.push_str(", ...");
    }
    Err(finding(&format!("holds what generate did not make: {names}"))
        .hint("move it away; --force replaces only what generate made")
        .into())
}

/// Files in a set's folder that `generate` did not write: unknown names, and a form that somebody has filled in.
fn foreign(out: &Path, set: &StoredSet) -> Vec<String> {
    let mut found: Vec<String> = files::names_in(out)
        .into_iter()
        .filter(|n| {
            let ours = OF_SET.iter().chain(&output::BOOKLETS).chain(&output::KEY_TABLES);
            n != "students" && ours.into_iter().all(|o| o != n)
        })
        .collect();
    let folders: rustc_hash::FxHashSet<&str> = set.students.iter().map(|s| s.folder.as_str()).collect();
    for name in files::names_in(&out.join("students")) {
        if folders.contains(name.as_str()) {
            let inside = files::names_in(&out.join("students").join(&name));
            let unknown = inside.into_iter().filter(|n| !of_student(n, set.problems.len()));
            found.extend(unknown.map(|n| format!("students/{name}/{n}")));
        } else if !is_left_over(&out.join("students").join(&name), &name, set) {
            found.push(format!("students/{name}"));
        }
    }
    let form = files::read(&out.join("submissions.csv")).unwrap_or_default();
    if is_filled(&form) {
        found.push("submissions.csv (filled in)".to_owned());
    }
    found
}

/// `--add` to a set made otherwise would give sheets that do not belong together.
fn same_set(plan: &Plan, set: &StoredSet, out: &Path) -> Result<(), Findings> {
    let ids: Vec<&str> =
        plan.problems.iter().filter_map(|p| plan.bank.problems.get(*p)).map(|p| p.id.as_str()).collect();
    let mut faults = Findings::default();
    let mut differs = |what: &str, here: String, there: String| {
        if here != there {
            let file = out.join("set.json").display().to_string();
            faults
                .push(Finding::new(what, format!("the set has {there}, this command {here}")).in_file(file));
        }
    };
    differs("seed", plan.seed.to_string(), set.seed.to_string());
    differs("name", plan.name.to_owned(), set.name.clone());
    differs("problems", ids.join(","), set.problems.join(","));
    differs("language", plan.texts.words.language().to_owned(), set.language.clone());
    let formats: Vec<&str> = plan.formats.iter().map(|f| f.ending()).collect();
    differs("formats", formats.join(","), set.formats.join(","));
    differs("bank", plan.bank.hash.clone(), set.bank.sha256.clone());
    differs("draw version", stream::DRAW_VERSION.to_string(), set.draw_version.to_string());
    faults.into_result(())
}

/// What was made, and where to look.
fn tell(plan: &Plan, summary: &Summary, out: &Path, io: &mut Io) {
    let out = out.display();
    let parts: usize =
        plan.problems.iter().filter_map(|p| plan.bank.problems.get(*p)).map(|p| p.questions.len()).sum();
    io.line(&format!(
        "{} of {} with {} each, {} drawn and solved twice ({} draws), in {out}",
        count(summary.written, "sheet"),
        count(plan.problems.len(), "problem"),
        count(parts, "question"),
        count(summary.written * plan.problems.len(), "variant"),
        summary.tries
    ));
    let mut sheets: Vec<String> =
        plan.formats.iter().rev().map(|f| format!("sheet.{}", f.ending())).collect();
    sheets.push("sheet.json".to_owned());
    io.line(&format!("  for students:  {out}/students/ID/ ({}); nothing else", sheets.join(", ")));
    let has = |format| plan.formats.contains(&format);
    let booklet = Format::ALL.into_iter().rev().filter(|f| *f != Format::Md && has(*f));
    let booklet: Vec<String> = booklet.map(|f| format!("{out}/booklet.{}", f.ending())).collect();
    if !booklet.is_empty() {
        io.line(&format!("  to print:      {} (all sheets)", booklet.join(", ")));
    }
    io.line(&format!(
        "  the key:       {out}/key-table.html, {out}/key.csv; a form to fill in: {out}/submissions.csv"
    ));
    coincidences(summary, io);
}

/// Pairs too much alike, for the summary.
pub fn coincidences(summary: &Summary, io: &mut Io) {
    let found = &summary.set.coincidences;
    if found.is_empty() {
        io.line("  no two students have an equal problem or all answers of a problem within tolerance");
        return;
    }
    let cut = if summary.cut.is_empty() {
        String::new()
    } else {
        format!(" and more of {}", summary.cut.join(", "))
    };
    io.line(&format!(
        "  {}{cut} with an equal problem or all its answers within tolerance (all in set.json):",
        count(found.len(), "pair")
    ));
    for c in found.iter().take(8) {
        io.line(&format!("    {}: {} and {}, {}", c.problem, c.students[0], c.students[1], c.what));
    }
    if found.len() > 8 {
        io.line(&format!("    and {} more", found.len() - 8));
    }
}
