//! `slipstick accuracy`: what each method gives away for its speed, on one problem with given data.
use crate::cli::args;
use crate::cli::tell::{Exit, Io};
use crate::finding::{Finding, Findings};
use crate::folder::{banks, files};
use crate::inspect::{accuracy, data};
use std::path::{Path, PathBuf};

pub fn run(args: &args::AccuracyArgs, io: &mut Io) -> Result<Exit, Findings> {
    let outputs = outputs(args)?;
    let loaded = banks::load(&args.of.bank)?;
    let problem = banks::problem(&loaded, args.of.problem.as_deref())?;
    let data = data::data(&loaded.bank, problem, &args.of.set, args.of.seed)?;
    let (holds, study) = accuracy::measure(problem, &data, !args.no_time)?;
    match study {
        Ok(study) => {
            let mut texts = Vec::new();
            for (path, kind) in outputs {
                let text = match kind {
                    StudyFile::Csv => study.csv(),
                    StudyFile::Svg => study.plot().svg(),
                    StudyFile::Html => study.page()?,
                };
                texts.push((path, text));
            }
            files::put_all(&texts)?;
            io.piece(&study.text());
            for (path, _) in &texts {
                io.line(&format!("written: {}", path.display()));
            }
        }
        Err(told) => io.piece(&told),
    }
    Ok(if holds { Exit::Fine } else { Exit::RegimeFails })
}

#[derive(Clone, Copy)]
enum StudyFile {
    Csv,
    Html,
    Svg,
}

/// The files to write: of each the path and the kind.
fn outputs(args: &args::AccuracyArgs) -> Result<Vec<(PathBuf, StudyFile)>, Findings> {
    let mut found: Vec<(PathBuf, StudyFile)> = Vec::new();
    let mut faults = Findings::default();
    for path in &args.out {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            _ if path.is_dir() => found.extend(all_in(path)),
            Some("csv") => found.push((path.clone(), StudyFile::Csv)),
            Some("html" | "htm") => found.push((path.clone(), StudyFile::Html)),
            Some("svg") => found.push((path.clone(), StudyFile::Svg)),
            None => found.extend(all_in(path)),
            Some(other) => {
                let fault = Finding::new("--out", format!("files of the kind .{other} are not written"));
                let fault = fault.in_file(path.display().to_string());
                faults.push(fault.hint("write a name that ends in .csv, .html or .svg, or a folder"));
            }
        }
    }
    for (i, (path, _)) in found.iter().enumerate() {
        if found.iter().take(i).any(|(other, _)| other == path) {
            faults.push(Finding::new("--out", "is named twice").in_file(path.display().to_string()));
        } else {
            faults.extend(files::may_write_file(path, args.force).err());
        }
    }
    faults.into_result(found)
}

fn all_in(folder: &Path) -> [(PathBuf, StudyFile); 3] {
    [("accuracy.csv", StudyFile::Csv), ("accuracy.html", StudyFile::Html), ("accuracy.svg", StudyFile::Svg)]
        .map(|(name, kind)| (folder.join(name), kind))
}
