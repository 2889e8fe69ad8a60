//! `slipstick accuracy`: what each method gives away for its speed, on one problem with given data.
use crate::bank::Problem;
use crate::cli::args;
use crate::cli::banks;
use crate::cli::files;
use crate::cli::solve;
use crate::cli::tell;
use crate::cli::tell::Exit;
use crate::cli::tell::Io;
use crate::cli::words;
use crate::finding::Finding;
use crate::finding::Findings;
use crate::guard::push_line;
use crate::num::shown;
use crate::plot::Axis;
use crate::plot::Figure;
use crate::plot::Point;
use crate::plot::Scale;
use crate::plot::Series;
use crate::plot::svg::escaped;
use crate::scene::Label;
use crate::scene::Scene;
use crate::solve::ladder;
use crate::solve::ladder::Force;
use crate::solve::ladder::Row;
use crate::solve::ladder::Study;
use crate::solve::ladder::Taken;
use crate::solve::method::Method;
use crate::solve::method::Rung;
use crate::template;
use crate::template::Templates;
use crate::template::View;
use std::hint::black_box;
use std::path::Path;
use std::path::PathBuf;
use std::time::Duration;
use std::time::Instant;

/// Errors below this are drawn here: a double holds no less beside 1.
const NO_ERROR: f64 = 1e-17;
/// A batch of solves lasts at least this long.
const BATCH: Duration = Duration::from_micros(500);
/// Batches, of which the median counts.
const BATCHES: usize = 11;
/// A method that takes longer than this in all is timed by fewer batches.
const PATIENCE: Duration = Duration::from_millis(300);

/// Times within this share are equal.
const SAME_TIME: f64 = 0.1;

/// Runs it.
pub fn run(args: &args::Accuracy, io: &mut Io) -> Exit {
    match measured(args, io) {
        Ok(exit) => exit,
        Err(findings) => io.findings(&findings),
    }
}

/// One row as it is shown.
struct Line {
    row: Row,
    /// Median time of a solve, s.
    seconds: Option<f64>,
    /// Is it beaten by none in cost and error?
    best: bool,
}

/// Everything that was found out about a scene.
struct Sheet<'s> {
    problem: &'s Problem,
    scene: &'s Scene,
    shown: String,
    study: &'s Study,
    lines: Vec<Line>,
    timed: bool,
    taken: Taken,
    /// What really happens, if it is not what the problem declares.
    regime: String,
    /// Asked answers that do not exist here.
    missing: Vec<String>,
}

fn measured(args: &args::Accuracy, io: &mut Io) -> Result<Exit, Findings> {
    let outputs = outputs(args)?;
    let loaded = banks::load(&args.bank)?;
    let problem = banks::problem(&loaded, &args.problem)?;
    let (case, data, shown) = solve::data(&loaded, problem, &args.set, args.seed)?;
    let scene = &problem.cases[case].scene;
    let refused = |refusal: &_| solve::refused(problem, scene, refusal);
    let (solved, taken) = ladder::solve(scene, &data, &ladder::Wish::default()).map_err(|r| refused(&r))?;
    if taken.force == Force::Instant {
        let fault =
            Finding::new(&problem.id, "only an instant is asked: nothing moves, there is nothing to compare");
        return Err(fault.hint("`slipstick solve` gives the answers").into());
    }
    let holds = solve::fits(problem, case, &solved);
    let shown = shown.join(", ");
    let exit = if holds { Exit::Fine } else { Exit::RegimeFails };
    let regime = if holds { String::new() } else { solve::regime(problem, case, &solved, holds) };
    if solved.get(ladder::TIME).is_none() {
        let regime = regime.replace(solve::NUMBERS_OF_TIES, "");
        io.piece(&format!(
            "{}: {shown}\n{regime}The motion does not get to its end: there is nothing to compare.\n",
            problem.id
        ));
        return Ok(exit);
    }
    let mut labels: Vec<Label> = Vec::new();
    for question in problem.questions.iter().filter(|q| !q.label.quantity.is_word()) {
        if !labels.contains(&question.label) {
            labels.push(question.label);
        }
    }
    let missing: Vec<String> =
        labels.iter().filter(|l| solved.get(**l).is_none()).map(|l| scene.name_of(*l)).collect();
    let study = ladder::study(scene, &data, &labels).map_err(|r| refused(&r))?;
    if study.labels.is_empty() {
        let fault = Finding::new(&problem.id, "none of the asked answers exists with these data");
        return Err(fault.hint("`slipstick solve` says what really happens").into());
    }
    let mut lines = Vec::with_capacity(study.rows.len());
    for row in &study.rows {
        let seconds =
            (!args.no_time && row.found.is_ok()).then(|| time(scene, &data, row.rung, &study.labels));
        lines.push(Line { row: row.clone(), seconds, best: false });
    }
    let pairs: Vec<(f64, f64)> = lines.iter().map(|l| (cost(l), worst(l))).collect();
    for (line, best) in
        lines.iter_mut().zip(ladder::pareto(&pairs, if args.no_time { 0.0 } else { SAME_TIME }))
    {
        line.best = best;
    }
    let sheet =
        Sheet { problem, scene, shown, study: &study, lines, timed: !args.no_time, taken, regime, missing };
    let mut texts = Vec::new();
    for (path, kind) in &outputs {
        let text = match kind {
            Kind::Csv => sheet.csv(),
            Kind::Svg => sheet.plot().svg(),
            Kind::Html => sheet.page()?,
        };
        texts.push((path.clone(), text));
    }
    files::put_all(&texts)?;
    io.piece(&sheet.text());
    for (path, _) in &texts {
        io.line(&format!("written: {}", path.display()));
    }
    Ok(exit)
}

fn cost(line: &Line) -> f64 {
    match (&line.row.found, line.seconds) {
        (_, Some(seconds)) => seconds,
        (Ok(found), None) => found.count.evaluations as f64,
        (Err(_), None) => f64::INFINITY,
    }
}

fn worst(line: &Line) -> f64 {
    line.row.found.as_ref().map_or(f64::INFINITY, |f| f.worst)
}

/// Median time of one solve by a rung, s, over batches.
fn time(scene: &Scene, data: &[f64], rung: Rung, labels: &[Label]) -> f64 {
    let batch = |n: u32| {
        let start = Instant::now();
        for _ in 0..n {
            let _ = black_box(ladder::once(black_box(scene), black_box(data), rung, labels));
        }
        start.elapsed()
    };
    // The first run warms up and tells how many make a batch.
    let first = batch(1).min(batch(1)).max(Duration::from_nanos(20));
    let n = u32::try_from(BATCH.as_nanos() / first.as_nanos() + 1).unwrap_or(1);
    let mut times = Vec::with_capacity(BATCHES);
    let begun = Instant::now();
    while times.len() < BATCHES && (times.len() < 3 || begun.elapsed() < PATIENCE) {
        times.push(batch(n).as_secs_f64() / f64::from(n));
    }
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

#[derive(Clone, Copy)]
enum Kind {
    Csv,
    Html,
    Svg,
}

/// The files to write: of each the path and the kind.
fn outputs(args: &args::Accuracy) -> Result<Vec<(PathBuf, Kind)>, Findings> {
    let mut found: Vec<(PathBuf, Kind)> = Vec::new();
    let mut faults = Findings::default();
    for path in &args.out {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            _ if path.is_dir() => found.extend(all_in(path)),
            Some("csv") => found.push((path.clone(), Kind::Csv)),
            Some("html" | "htm") => found.push((path.clone(), Kind::Html)),
            Some("svg") => found.push((path.clone(), Kind::Svg)),
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
        } else if path.exists() && !args.force {
            let fault = Finding::new("--out", "is there already").in_file(path.display().to_string());
            faults.push(fault.hint("--force replaces it"));
        }
    }
    faults.into_result(found)
}

fn all_in(folder: &Path) -> [(PathBuf, Kind); 3] {
    [("accuracy.csv", Kind::Csv), ("accuracy.html", Kind::Html), ("accuracy.svg", Kind::Svg)]
        .map(|(name, kind)| (folder.join(name), kind))
}

/// `1.23 us`
fn duration(seconds: f64) -> String {
    let (factor, unit) = match seconds {
        s if s < 1e-6 => (1e9, "ns"),
        s if s < 1e-3 => (1e6, "us"),
        s if s < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {unit}", words::rounded(seconds * factor, 3))
}

/// An error with two figures.
fn short(error: f64) -> String {
    if error == 0.0 {
        "0".to_owned()
    } else if error.is_finite() {
        shown::figures(error, 2)
    } else {
        "none".to_owned()
    }
}

/// Delivered error over requested tolerance, if a tolerance was requested.
fn ratio(line: &Line) -> Option<f64> {
    Some(line.row.found.as_ref().ok()?.worst / line.row.rung.requested()?)
}

impl Sheet<'_> {
    fn names(&self) -> Vec<String> {
        self.study.labels.iter().map(|l| self.scene.name_of(*l)).collect()
    }

    fn head(&self) -> Vec<String> {
        let mut head: Vec<String> = ["", "method", "setting", "evaluations"].map(str::to_owned).to_vec();
        if self.timed {
            head.push("time".to_owned());
        }
        head.extend(self.names());
        head.extend(["worst", "given/asked"].map(str::to_owned));
        head
    }

    fn cells(&self, line: &Line) -> Vec<String> {
        let mark = match (line.best, line.row.auto) {
            (true, true) => "* auto",
            (true, false) => "*",
            (false, true) => "  auto",
            (false, false) => "",
        };
        let rung = line.row.rung;
        let mut cells = vec![mark.to_owned(), rung.method().name().to_owned(), words::setting(rung)];
        match &line.row.found {
            Ok(found) => {
                cells.push(found.count.evaluations.to_string());
                cells.extend(line.seconds.map(duration));
                cells.extend(found.errors.iter().map(|e| short(*e)));
                cells.push(short(found.worst));
                cells.push(ratio(line).map_or_else(String::new, |r| words::rounded(r, 2)));
            }
            Err(_) => {
                cells.push("refused".to_owned());
                let more = self.names().len() + 2 + usize::from(self.timed);
                cells.extend(std::iter::repeat_n(String::new(), more));
            }
        }
        cells
    }

    /// What the program chooses, in a sentence.
    fn choice(&self) -> String {
        format!("auto takes the {}: {}", words::rung(self.taken.rung), words::why(&self.taken))
    }

    /// Why rows have no result.
    fn refusals(&self) -> Vec<String> {
        let mut list = Vec::new();
        for line in &self.lines {
            if let Err(refusal) = &line.row.found {
                let setting = words::setting(line.row.rung);
                for text in words::refusal(self.problem, self.scene, refusal) {
                    list.push(format!("{setting}: {text}"));
                }
            }
        }
        list
    }

    fn text(&self) -> String {
        let mut out = format!("{}: {}\n{}", self.problem.id, self.shown, self.regime);
        out.push_str(&self.choice());
        out.push_str(
            "\nrelative errors against a reference in double-double (0: the nearest double); * is beaten by no other row\n",
        );
        let mut rows = vec![self.head()];
        rows.extend(self.lines.iter().map(|l| self.cells(l)));
        out.push_str(&tell::table(&rows, &[0, 1, 2]));
        if !self.missing.is_empty() {
            out.push_str(&format!(
                "not compared, for they do not exist with these data: {}\n",
                self.missing.join(", ")
            ));
        }
        for refusal in self.refusals() {
            out.push_str(&format!("  {refusal}\n"));
        }
        out
    }

    fn csv(&self) -> String {
        let mut out = Vec::new();
        let mut head: Vec<String> =
            ["problem", "method", "setting", "step_s", "rtol", "points", "evaluations", "steps"]
                .map(str::to_owned)
                .to_vec();
        if self.timed {
            head.push("seconds".to_owned());
        }
        head.extend(self.names().iter().map(|n| format!("error of {n}")));
        head.extend(["worst error", "given/asked", "unbeaten", "auto", "refused"].map(str::to_owned));
        push_line(&mut out, &head);
        for line in &self.lines {
            let rung = line.row.rung;
            let (mut step, mut rtol, mut points) = (String::new(), String::new(), String::new());
            match rung {
                Rung::Closed | Rung::Doubles | Rung::Settled => {}
                Rung::Gauss(n) => points = n.to_string(),
                Rung::Adaptive(_, tolerance, _) => rtol = format!("{tolerance:e}"),
                Rung::Fixed(_, h) => step = format!("{h:e}"),
            }
            let mut record = vec![
                self.problem.id.clone(),
                rung.method().name().to_owned(),
                words::setting(rung),
                step,
                rtol,
                points,
            ];
            let yes = |b: bool| if b { "yes" } else { "no" }.to_owned();
            match &line.row.found {
                Ok(found) => {
                    record.extend([found.count.evaluations.to_string(), found.count.steps.to_string()]);
                    record.extend(line.seconds.map(|s| format!("{s:.3e}")));
                    record.extend(found.errors.iter().map(|e| format!("{e:.3e}")));
                    record.push(format!("{:.3e}", found.worst));
                    record.push(ratio(line).map_or_else(String::new, |r| format!("{r:.3e}")));
                    record.extend([yes(line.best), yes(line.row.auto), String::new()]);
                }
                Err(refusal) => {
                    let empty = 2 + usize::from(self.timed) + self.names().len() + 2;
                    record.extend(std::iter::repeat_n(String::new(), empty));
                    let why = words::refusal(self.problem, self.scene, refusal).join("; ");
                    record.extend([yes(false), yes(line.row.auto), why]);
                }
            }
            push_line(&mut out, &record);
        }
        String::from_utf8(out).unwrap_or_default()
    }

    /// Error against cost, one line for each method.
    fn plot(&self) -> Figure {
        // What is not a number has no place: least of all that of no error.
        let shown = |l: &&Line| worst(l).is_finite();
        let series = Method::ALL.iter().enumerate().map(|(style, method)| Series {
            name: method.name().to_owned(),
            style,
            points: self
                .lines
                .iter()
                .filter(|l| l.row.rung.method() == *method && l.row.rung != Rung::Settled)
                .filter(shown)
                .map(|l| Point { x: cost(l), y: worst(l).max(NO_ERROR), filled: l.best, ringed: l.row.auto })
                .collect(),
        });
        // What settles by itself is no point of a line.
        let settled = self.lines.iter().filter(|l| l.row.rung == Rung::Settled).filter(shown);
        let settled = settled.map(|l| Series {
            name: "gauss, settled".to_owned(),
            style: 0,
            points: vec![Point { x: cost(l), y: worst(l).max(NO_ERROR), filled: l.best, ringed: l.row.auto }],
        });
        let settled: Vec<Series> = settled.collect();
        let series: Vec<Series> =
            settled.into_iter().chain(series).filter(|s| !s.points.is_empty()).collect();
        let points = || series.iter().flat_map(|s| &s.points);
        let label = if self.timed { "time of one solve, s" } else { "force evaluations of one solve" };
        let ys = points().map(|p| p.y).chain([NO_ERROR]);
        Figure {
            id: format!("error-{}", self.problem.id),
            title: format!("{}: error against cost", self.problem.title),
            description: self.described(),
            x: Axis::around(label, Scale::Log, points().map(|p| p.x)),
            y: Axis::around("greatest relative error of the asked answers", Scale::Log, ys),
            notes: ["filled: unbeaten", "ring: what auto takes", "bottom: no error"]
                .map(str::to_owned)
                .to_vec(),
            series,
        }
    }

    /// What the plot shows, for those who do not see it.
    fn described(&self) -> String {
        let best = |method: Method| {
            let of = self.lines.iter().filter(|l| l.row.rung.method() == method && l.row.found.is_ok());
            of.min_by(|a, b| worst(a).total_cmp(&worst(b)))
        };
        let list: Vec<String> = Method::ALL
            .iter()
            .filter_map(|m| best(*m))
            .map(|l| {
                let unit = if self.timed { duration(cost(l)) } else { format!("{} evaluations", cost(l)) };
                format!("{} reaches {} in {unit}", l.row.rung.method().name(), short(worst(l)))
            })
            .collect();
        format!(
            "Greatest relative error of the asked answers against cost, both axes logarithmic. {}.",
            list.join("; ")
        )
    }

    /// Delivered error against requested tolerance.
    fn tolerance_plot(&self) -> Option<Figure> {
        let mut series = vec![Series { name: "as asked".to_owned(), style: 0, points: Vec::new() }];
        for (style, method) in Method::ALL.iter().enumerate() {
            let points: Vec<Point> = self
                .lines
                .iter()
                .filter(|l| l.row.rung.method() == *method && worst(l).is_finite())
                .filter_map(|l| {
                    let x = l.row.rung.requested()?;
                    Some(Point { x, y: worst(l).max(NO_ERROR), filled: true, ringed: false })
                })
                .collect();
            if !points.is_empty() {
                series.push(Series { name: method.name().to_owned(), style, points });
            }
        }
        let xs: Vec<f64> = series.iter().flat_map(|s| s.points.iter().map(|p| p.x)).collect();
        let (low, high) = xs.iter().fold((f64::INFINITY, 0.0f64), |(l, h), x| (l.min(*x), h.max(*x)));
        if xs.len() < 2 {
            return None;
        }
        series[0].points = [low, high].map(|x| Point { x, y: x, filled: false, ringed: false }).to_vec();
        let ys: Vec<f64> = series.iter().flat_map(|s| s.points.iter().map(|p| p.y)).collect();
        Some(Figure {
            id: format!("tolerance-{}", self.problem.id),
            title: "Error of the result against tolerance of a step".to_owned(),
            description: "Greatest relative error of the asked answers against the requested tolerance, both axes logarithmic."
                .to_owned(),
            x: Axis::around("requested tolerance", Scale::Log, xs.into_iter()),
            y: Axis::around("delivered error", Scale::Log, ys.into_iter().chain([NO_ERROR])),
            series,
            notes: vec!["bottom: no error".to_owned()],
        })
    }

    fn page(&self) -> Result<String, Findings> {
        let mut view = View::new();
        view.foreign("title", &self.problem.title);
        view.foreign("data", &format!("{}: {}", self.problem.id, self.shown));
        let mut choice = self.choice();
        choice.replace_range(..1, "A");
        view.foreign("choice", &format!("{choice}."));
        view.text("plot", &self.plot().svg());
        let cost = if self.timed {
            "time of a whole solve by its method (median of batches)"
        } else {
            "number of force evaluations"
        };
        view.foreign(
            "reading",
            &format!(
                "Each mark is one run; along a line the step or the tolerance gets finer from left to right. Down is more exact, left is cheaper; the cost is the {cost}. Filled marks are beaten by no other run in both. Errors are those against a reference in double-double (32 digits); a double ends near 1e-16."
            ),
        );
        let plot = self.tolerance_plot().map_or_else(String::new, |f| f.svg());
        view.text("tolerance_plot", &plot);
        let text = |t: &str| template::finished(&escaped(t));
        view.value("head", template::list(self.head().iter().map(|t| text(t)).collect()));
        let mut before = None;
        let rows = self.lines.iter().map(|line| {
            let method = line.row.rung.method();
            let mut style = Vec::new();
            if before.replace(method) != Some(method) {
                style.push("first");
            }
            if line.row.found.is_err() {
                style.push("refused");
            } else if line.best {
                style.push("best");
            }
            let cells = self.cells(line).iter().map(|t| text(t)).collect();
            template::map([("style", text(&style.join(" "))), ("cells", template::list(cells))])
        });
        view.value("rows", template::list(rows.collect()));
        view.value("notes", template::list(self.refusals().iter().map(|t| text(t)).collect()));
        let mut out = Vec::new();
        Templates::english().render("accuracy.html", &view, &mut out)?;
        Ok(String::from_utf8(out).unwrap_or_default())
    }
}
