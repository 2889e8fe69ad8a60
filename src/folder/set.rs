//! A set as it lies on disk: opened, replayed, held against what a command would write.
use crate::answer::roster;
use crate::bank::{Bank, load};
use crate::draw::stream;
use crate::finding::{Finding, Findings};
use crate::folder::deal::Plan;
use crate::folder::files::{NewFolder, names_in};
use crate::folder::{banks, files, names};
use crate::key::SheetKey;
use crate::page::sheet_file::SheetFile;
use crate::set::store::StoredSet;
use crate::set::{key_file, replay};
use crate::sheet::terminal;
use crate::words::plain::beginning;
use std::path::Path;

/// A set, its bank and its keys.
pub struct Replayed {
    /// What was drawn.
    pub set: StoredSet,
    /// The bank beside it.
    pub bank: Bank,
    /// The keys, made anew; of a set that an earlier version drew those that are stored.
    pub keys: Vec<SheetKey>,
    /// Of such a set: that it was not drawn again, and what its key was held against.
    pub not_drawn: Option<String>,
    /// By both roads, and with wrong methods? Else by the first alone, see [`for_grading`].
    pub whole: bool,
}

/// The set in a folder and the copy of the bank beside it. Errors: there is none, or a file of it cannot be read.
pub fn with_bank(folder: &Path) -> Result<(StoredSet, Bank), Findings> {
    let set = open(folder)?;
    let path = folder.join(&set.bank.file);
    let text = files::read_text(&path)?;
    let bank = banks::parse(&text, &path.display().to_string())?;
    Ok((set, bank))
}

/// What a replay found, told of the file of the set where no other is named.
pub fn of_set(folder: &Path, faults: Findings) -> Findings {
    faults.or_in_file(&folder.join(names::SET).display().to_string())
}

/// The set in a folder and its key, as grading needs them. Where key.csv has the hash that was stored with the set, every variant is
/// drawn again and solved by one road, which must give the stored answers and tolerances: both roads and their proof were there
/// when the set was made, and wrong methods are found when an answer is wrong. Where anything differs, the set is [`replayed`],
/// which tells what. Errors: those of `replayed`.
pub fn for_grading(folder: &Path) -> Result<Replayed, Findings> {
    let (set, bank) = with_bank(folder)?;
    let stored = files::read(&folder.join(names::KEY))?;
    let sealed = set.key_sha256 == Some(load::hash(&String::from_utf8_lossy(&stored)));
    let keys = if sealed { replay::by_first_road(&bank, &set) } else { None };
    match keys.filter(|keys| key_file::grades_as(&stored, keys)) {
        Some(keys) => Ok(Replayed { set, bank, keys, not_drawn: None, whole: false }),
        None => replayed(folder),
    }
}

/// The set in a folder and its key, made anew and compared with what is stored. A set of an earlier version of the drawing is not
/// drawn again: its key is the stored one, which must have the hash that was stored with it. Errors: the set is not what it was
/// made as.
pub fn replayed(folder: &Path) -> Result<Replayed, Findings> {
    let (set, bank) = with_bank(folder)?;
    let name = folder.join(&set.bank.file).display().to_string();
    let in_set = |faults: Findings| -> Findings {
        let file = folder.join(names::SET).display().to_string();
        faults
            .into_iter()
            .map(|f| if f.file.is_none() { f.in_file(&file) } else { f.in_file(&name) })
            .collect()
    };
    let mut keys = replay::keys(&bank, &set).map_err(in_set)?;
    let path = folder.join(names::KEY);
    let stored = files::read(&path)?;
    let file = path.display().to_string();
    let earlier = replay::is_earlier(&set);
    let seal = set.key_sha256.as_ref().filter(|_| earlier);
    let hash = || load::hash(&String::from_utf8_lossy(&stored));
    if let Some((seal, hash)) = seal.map(|seal| (seal, hash())).filter(|(seal, hash)| *seal != hash) {
        let [is, was] = [&hash, seal].map(|hash| beginning(hash, 12));
        let what = format!("was changed: its SHA-256 is {is}, that of the set's key is {was}");
        let fault = Finding::new("", what).in_file(file);
        return Err(fault.hint("put the original back, or make the set anew").into());
    }
    let (other, faults) = match earlier {
        true => match key_file::put_stored(&stored, &mut keys, seal.is_some()) {
            Ok(other) => (other, Findings::default()),
            Err(faults) => (0, faults.in_file(file)),
        },
        false => (0, key_file::compare(&stored, &keys).in_file(file)),
    };
    let hint = match earlier {
        true => {
            format!("put the original back; if it is, grade with the version that made it: {}", set.program)
        }
        false => "key.csv is not what the set gives: put the original back, or make the set anew".to_owned(),
    };
    faults.hint_last(&hint).into_result(())?;
    let not_drawn = earlier.then(|| {
        let held = match seal {
            Some(_) => "which has the SHA-256 that is stored with the set",
            None => "which agrees with what the stored data give",
        };
        let mut told = format!(
            "The set was drawn by draw version {}, this program has {}: it was not replayed. Its key is the stored one, {held}.",
            set.draw_version,
            stream::DRAW_VERSION
        );
        if other > 0 {
            let answers = terminal::count(other, "answer");
            told.push_str(&format!(" By this version the stored data would give {answers} of it otherwise."));
        }
        told
    });
    Ok(Replayed { set, bank, keys, not_drawn, whole: true })
}

/// The set that stands in a folder. Errors: there is none, or its file cannot be read.
pub fn open(folder: &Path) -> Result<StoredSet, Findings> {
    let path = folder.join(names::SET);
    if folder.is_file() {
        let fault = Finding::of_file(folder, "is a file; a set is a folder");
        return Err(fault.hint("give the folder that `slipstick generate` made").into());
    }
    if !path.is_file() {
        let hint = "a set is a folder that `slipstick generate` made; it has a file set.json";
        return Err(Finding::of_file(folder, "holds no set").hint(hint).into());
    }
    let text = files::read_text(&path)?;
    Ok(StoredSet::parse(&text).map_err(|f| f.in_file(path.display().to_string()))?)
}

/// May a set be written here? Nothing, an empty folder, or with `--force` a set and nothing else. Errors: what is in the way.
pub fn may_write(out: &Path, force: bool, example: &str, taken: &str) -> Result<(), Findings> {
    let new = NewFolder { verb: "generate", makes: "set", example, taken };
    files::may_write_folder(out, force, &new, || match out.join(names::SET).is_file() {
        true => Ok(Some(foreign(out, &open(out)?))),
        false => Ok(None),
    })
}

/// Files in a set's folder that `generate` did not write: unknown names, and a form that somebody has filled in.
fn foreign(out: &Path, set: &StoredSet) -> Vec<String> {
    let mut found: Vec<String> =
        names_in(out).into_iter().filter(|n| n != names::STUDENTS && !names::is_of_set(n)).collect();
    let folders: rustc_hash::FxHashSet<&str> = set.students.iter().map(|s| s.folder.as_str()).collect();
    for name in names_in(&out.join(names::STUDENTS)) {
        if folders.contains(name.as_str()) {
            let inside = names_in(&out.join(names::STUDENTS).join(&name));
            let unknown = inside.into_iter().filter(|n| !names::is_of_student(n, set.problems.len()));
            found.extend(unknown.map(|n| format!("students/{name}/{n}")));
        } else if !names::is_of_site(&name)
            && !is_left_over(&out.join(names::STUDENTS).join(&name), &name, set)
        {
            found.push(format!("students/{name}"));
        }
    }
    let form = files::read(&out.join(names::FORM)).unwrap_or_default();
    if is_filled(&form) {
        found.push("submissions.csv (filled in)".to_owned());
    }
    found
}

/// Is this a student's folder that an `--add` to this set made and did not enter? It holds a sheet of this set and
/// nothing else, under the name that the sheet's student would have, who is not in the set.
pub fn is_left_over(folder: &Path, name: &str, set: &StoredSet) -> bool {
    let inside = names_in(folder);
    let exactly = inside.iter().all(|n| names::is_of_student(n, set.problems.len()));
    let sheet = || SheetFile::parse(&files::read_text(&folder.join(names::SHEET)).ok()?).ok();
    exactly
        && sheet().is_some_and(|sheet| {
            sheet.set == set.name
                && roster::folder(&sheet.student) == name
                && set.students.iter().all(|s| s.student != sheet.student)
        })
}

/// Has nobody written into the form?
pub fn form_is_blank(out: &Path) -> bool {
    files::read(&out.join(names::FORM)).is_ok_and(|form| !is_filled(&form))
}

fn is_filled(form: &[u8]) -> bool {
    String::from_utf8_lossy(form).lines().skip(1).any(|l| !l.ends_with(',') && !l.trim().is_empty())
}

/// `--add` to a set made otherwise would give sheets that do not belong together. Errors: what differs.
pub fn same_set(plan: &Plan, set: &StoredSet, out: &Path) -> Result<(), Findings> {
    let ids: Vec<&str> = plan.chosen().map(|p| p.id.as_str()).collect();
    let formats: Vec<&str> = plan.formats.iter().map(|f| f.as_str()).collect();
    let both: [(&str, &str, &str); 8] = [
        ("seed", &plan.seed.to_string(), &set.seed.to_string()),
        ("name", plan.name, &set.name),
        ("problems", &ids.join(","), &set.problems.join(",")),
        ("language", plan.texts.words.language(), &set.language),
        ("formats", &formats.join(","), &set.formats.join(",")),
        ("page", plan.hosting.as_str(), set.page.as_str()),
        ("bank", &plan.bank.hash, &set.bank.sha256),
        ("draw version", &stream::DRAW_VERSION.to_string(), &set.draw_version.to_string()),
    ];
    let differ = both.into_iter().filter(|(_, here, there)| here != there);
    let faults: Findings = differ
        .map(|(what, here, there)| Finding::new(what, format!("the set has {there}, this command {here}")))
        .collect();
    faults.in_file(out.join(names::SET).display().to_string()).into_result(())
}
