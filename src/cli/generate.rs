//! `slipstick generate`: bank and roster to a folder with a sheet for each student.
use crate::answer::roster::composed;
use crate::cli::tell::{Exit, Io};
use crate::cli::{args, tell};
use crate::finding::Findings;
use crate::folder::deal::{Plan, SetMade};
use crate::folder::{self, banks, deal, names, set, staged};
use crate::review;
use crate::set::dealer;
use crate::sheet::{output, terminal, texts};
use std::path::Path;

pub fn run(args: &args::GenerateArgs, io: &mut Io) -> Result<Exit, Findings> {
    let mut faults = Findings::default();
    // First of all: a set that a killed run had moved aside goes back.
    staged::sweep_beside(&args.out);
    let loaded = banks::load(&args.bank).map_err(|f| faults.extend(f)).ok();
    let members = deal::members(&args.roster).map_err(|f| faults.extend(f)).ok();
    let (Some(mut loaded), Some(mut members)) = (loaded, members) else { return Err(faults) };
    let old = if args.add { Some(set::open(&args.out)?) } else { None };
    let usual = old.as_ref().map_or("en", |set| set.language.as_str());
    let texts = args.own.texts_or(usual, &mut loaded.bank)?;
    let formats = match (&args.format, &old) {
        (None, Some(set)) => output::stored(&set.formats),
        (asked, _) => output::formats(asked.as_deref()),
    };
    // A name that is not known is told with its place when the sheet is written.
    if texts::unknown_names(&loaded.bank, &texts.templates).is_empty() {
        let lacking = texts::never_given(&loaded.bank, &texts.templates);
        lacking.into_result(())?;
    }
    if old.is_none() {
        set::may_write(
            &args.out,
            args.force,
            "--out week-5",
            "give another --out, or --force to replace a set, or --add for late joiners",
        )?;
    }
    let name = match (&args.name, &old) {
        (Some(name), _) => name.clone(),
        (None, Some(set)) => set.name.clone(),
        (None, None) => loaded.bank.id.clone(),
    };
    deal::may_be_named(&name)?;
    let problems = match (&args.problems, &old) {
        (None, Some(set)) => dealer::indices(&loaded.bank, &set.problems, "problems")?,
        (asked, _) => dealer::chosen(&loaded.bank, asked.as_deref(), "--problems")?,
    };
    // What a text of one's own gets wrong in a formula, students would see as raw commands.
    let tried = review::tried_texts::tried(&loaded.bank, &texts, &problems)?;
    tried.faults.into_result(())?;
    // What only the worked solutions will lack is told now, as `lint` does, and refuses nothing.
    for fault in &tried.unsolved {
        io.note(&format!("note: {fault}"));
    }
    for note in &tried.notes {
        io.note(&format!("note: problems.{}: {}", note.problem, note.what));
    }
    let seed = args.seed.or(old.as_ref().map(|s| s.seed)).unwrap_or(0);
    let hosting = args.page.or(old.as_ref().map(|s| s.page)).unwrap_or_default();
    let plan = Plan {
        bank: &loaded.bank,
        text: &loaded.text,
        texts: &texts,
        formats: &formats,
        hosting,
        problems: &problems,
        seed,
        name: &name,
    };
    if let Some(set) = &old {
        set::same_set(&plan, set, &args.out)?;
        let known: rustc_hash::FxHashSet<String> =
            set.students.iter().map(|s| composed(&s.student)).collect();
        members.retain(|m| !known.contains(&composed(&m.student)));
        deal::repair(&plan, set, &args.out, members.is_empty())?;
        if members.is_empty() {
            io.line("Nobody to add: every student of the roster has a sheet already.");
            io.open(&args.out.join(names::INDEX), args.open);
            return Ok(Exit::Fine);
        }
    }
    let pool = folder::pool(args.threads)?;
    let bar = io.bar();
    let made = pool.install(|| match &old {
        Some(set) => deal::add(&plan, &members, set, &args.out, &bar),
        None => deal::whole(&plan, &members, &args.out, &bar),
    })?;
    told(&plan, &made, &args.out, io);
    for note in review::seldom_words(&loaded.bank, &problems) {
        io.line(&format!("  note: {}: {}", note.field, note.message));
    }
    for m in members.iter().filter(|m| m.folder != m.student) {
        io.line(&format!("  {} is in students/{}", m.student, m.folder));
    }
    io.open(&args.out.join(names::INDEX), args.open);
    Ok(Exit::Fine)
}

/// What was made, and where to look.
fn told(plan: &Plan, made: &SetMade, folder: &Path, io: &mut Io) {
    let out = folder.display();
    let parts: usize = plan.chosen().map(|p| p.questions.len()).sum();
    io.line(&format!(
        "{} of {} with {} each, {} drawn and solved twice ({} draws), in {out}",
        terminal::count(made.written, "sheet"),
        terminal::count(plan.problems.len(), "problem"),
        terminal::count(parts, "question"),
        terminal::count(made.written * plan.problems.len(), "variant"),
        made.tries
    ));
    let mut sheets: Vec<String> =
        plan.formats.iter().rev().map(|f| format!("sheet.{}", f.as_str())).collect();
    sheets.push("sheet.json".to_owned());
    io.line(&format!("  start with:    {out}/{}", names::INDEX));
    let sheets = sheets.join(", ");
    io.line(&match plan.has_program() {
        true => format!(
            "  for students:  {out}/students as a whole, on a web server; give each the address of ID/sheet.html in it\n                 ({sheets}; the sheets check themselves with the two files beside the folders)"
        ),
        false => format!("  for students:  {out}/students/ID/ ({sheets}); nothing else"),
    });
    let booklets = tell::booklets(plan.formats, folder);
    if !booklets.is_empty() {
        io.line(&format!("  to print:      {booklets} (all sheets)"));
    }
    io.line(&format!(
        "  the key:       {out}/key-table.html, {out}/key.csv; a form to fill in: {out}/submissions.csv"
    ));
    io.line(&made.coincidences());
}
