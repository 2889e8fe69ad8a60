//! What each method gives away for its speed, on one problem with given data: measured, as table, CSV, plot and page.
use crate::bank::Problem;
use crate::csv_field::push_line;
use crate::finding::{Finding, Findings, push_new};
use crate::inspect::data::{Data, fits, refused};
use crate::inspect::table::NUMBERS_OF_TIES;
use crate::inspect::{sentences, table};
use crate::num::shown;
use crate::picture::svg::escaped;
use crate::plot::{Axis, AxisScale, Caption, DataPoint, LineChart, Series};
use crate::scene::{Label, Scene};
use crate::sheet::terminal;
use crate::solve::ladder::{self, Force, Row, Study, Taken};
use crate::solve::method::{Method, Rung};
use crate::template::{self, Templates, View};
use std::hint::black_box;
use std::time::{Duration, Instant};

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

struct MeasuredRow {
    row: Row,
    /// Median time of a solve, s.
    seconds: Option<f64>,
    /// Is it beaten by none in cost and error?
    best: bool,
}

/// Everything that was found out about a scene.
pub struct StudySheet<'s> {
    problem: &'s Problem,
    scene: &'s Scene,
    shown: String,
    study: Study,
    lines: Vec<MeasuredRow>,
    timed: bool,
    taken: Taken,
    /// What really happens, if it is not what the problem declares.
    regime: String,
    /// Asked answers that do not exist here.
    missing: Vec<String>,
}

/// Measures every method on a problem with these data, with the clock if `timed`. Whether what happens is what the problem declares;
/// and the study, or in words that there is nothing to compare. Errors: the scene has no answer with these data, or nothing is
/// asked that moves.
pub fn measure<'s>(
    problem: &'s Problem,
    (case, data, shown): &Data,
    timed: bool,
) -> Result<(bool, Result<StudySheet<'s>, String>), Findings> {
    let scene = &problem.cases[*case].scene;
    let refused = |refusal: &_| refused(problem, scene, refusal);
    let (solved, taken) = ladder::solve(scene, data, &ladder::Wish::default()).map_err(|r| refused(&r))?;
    if taken.force == Force::Instant {
        let fault =
            Finding::new(&problem.id, "only an instant is asked: nothing moves, there is nothing to compare");
        return Err(fault.hint("`slipstick solve` gives the answers").into());
    }
    let holds = fits(problem, *case, &solved);
    let shown = shown.join(", ");
    let regime = if holds { String::new() } else { table::regime(problem, *case, &solved, holds) };
    if solved.get(ladder::TIME).is_none() {
        let regime = regime.replace(NUMBERS_OF_TIES, "");
        let told = "The motion does not get to its end: there is nothing to compare.";
        return Ok((holds, Err(format!("{}: {shown}\n{regime}{told}\n", problem.id))));
    }
    let mut labels: Vec<Label> = Vec::new();
    for label in problem.questions.iter().map(|q| q.label).filter(|l| !l.quantity.is_word()) {
        push_new(&mut labels, label);
    }
    let missing: Vec<String> =
        labels.iter().filter(|l| solved.get(**l).is_none()).map(|l| scene.name_of(*l)).collect();
    let study = ladder::study(scene, data, &labels).map_err(|r| refused(&r))?;
    if study.labels.is_empty() {
        let fault = Finding::new(&problem.id, "none of the asked answers exists with these data");
        return Err(fault.hint("`slipstick solve` says what really happens").into());
    }
    let mut lines = Vec::with_capacity(study.rows.len());
    for row in &study.rows {
        let seconds = (timed && row.found.is_ok()).then(|| time(scene, data, row.rung, &study.labels));
        lines.push(MeasuredRow { row: row.clone(), seconds, best: false });
    }
    let pairs: Vec<(f64, f64)> = lines.iter().map(|l| (cost(l), worst(l))).collect();
    let same = if timed { SAME_TIME } else { 0.0 };
    for (line, best) in lines.iter_mut().zip(ladder::pareto(&pairs, same)) {
        line.best = best;
    }
    Ok((holds, Ok(StudySheet { problem, scene, shown, study, lines, timed, taken, regime, missing })))
}

fn cost(line: &MeasuredRow) -> f64 {
    match (&line.row.found, line.seconds) {
        (_, Some(seconds)) => seconds,
        (Ok(found), None) => found.count.evaluations as f64,
        (Err(_), None) => f64::INFINITY,
    }
}

fn worst(line: &MeasuredRow) -> f64 {
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

/// `1.23 us`
fn duration(seconds: f64) -> String {
    let (factor, unit) = match seconds {
        s if s < 1e-6 => (1e9, "ns"),
        s if s < 1e-3 => (1e6, "us"),
        s if s < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {unit}", shown::significant(seconds * factor, 3))
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
fn ratio(line: &MeasuredRow) -> Option<f64> {
    Some(line.row.found.as_ref().ok()?.worst / line.row.rung.requested()?)
}

impl StudySheet<'_> {
    fn names(&self) -> Vec<String> {
        self.study.labels.iter().map(|l| self.scene.name_of(*l)).collect()
    }

    fn head(&self) -> Vec<String> {
        let mut head = terminal::head(" | method | setting | evaluations");
        if self.timed {
            head.push("time".to_owned());
        }
        head.extend(self.names());
        head.extend(["worst", "given/asked"].map(str::to_owned));
        head
    }

    fn cells(&self, line: &MeasuredRow) -> Vec<String> {
        let mark = match (line.best, line.row.auto) {
            (true, true) => "* auto",
            (true, false) => "*",
            (false, true) => "  auto",
            (false, false) => "",
        };
        let rung = line.row.rung;
        let mut cells = vec![mark.to_owned(), rung.method().as_str().to_owned(), sentences::setting(rung)];
        match &line.row.found {
            Ok(found) => {
                cells.push(found.count.evaluations.to_string());
                cells.extend(line.seconds.map(duration));
                cells.extend(found.errors.iter().map(|e| short(*e)));
                cells.push(short(found.worst));
                cells.push(ratio(line).map_or_else(String::new, |r| shown::significant(r, 2)));
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
        format!("auto takes the {}: {}", sentences::rung(self.taken.rung), sentences::why(&self.taken))
    }

    /// Why rows have no result.
    fn refusals(&self) -> Vec<String> {
        let refused = self.lines.iter().filter_map(|l| Some((l.row.rung, l.row.found.as_ref().err()?)));
        let told = |(rung, refusal)| {
            let setting = sentences::setting(rung);
            let texts = sentences::refusal(self.problem, self.scene, refusal).into_iter();
            texts.map(move |text| format!("{setting}: {text}"))
        };
        refused.flat_map(told).collect()
    }

    /// The table, for the terminal.
    pub fn text(&self) -> String {
        let mut out = format!("{}: {}\n{}", self.problem.id, self.shown, self.regime);
        out.push_str(&self.choice());
        out.push_str(
            "\nrelative errors against a reference in double-double (0: the nearest double); * is beaten by no other row\n",
        );
        let mut rows = vec![self.head()];
        rows.extend(self.lines.iter().map(|l| self.cells(l)));
        out.push_str(&terminal::table(&rows, &[0, 1, 2]));
        if !self.missing.is_empty() {
            let missing = self.missing.join(", ");
            out.push_str(&format!("not compared, for they do not exist with these data: {missing}\n"));
        }
        for refusal in self.refusals() {
            out.push_str(&format!("  {refusal}\n"));
        }
        out
    }

    /// Every row as CSV.
    pub fn csv(&self) -> String {
        let mut out = Vec::new();
        let mut head =
            terminal::head("problem | method | setting | step_s | rtol | points | evaluations | steps");
        if self.timed {
            head.push("seconds".to_owned());
        }
        head.extend(self.names().iter().map(|n| format!("error of {n}")));
        head.extend(["worst error", "given/asked", "unbeaten", "auto", "refused"].map(str::to_owned));
        push_line(&mut out, &head);
        for line in &self.lines {
            let rung = line.row.rung;
            let none = String::new;
            let [step, rtol, points] = match rung {
                Rung::Closed | Rung::Doubles | Rung::Settled => [none(), none(), none()],
                Rung::Gauss(n) => [none(), none(), n.to_string()],
                Rung::Adaptive(_, tolerance, _) => [none(), format!("{tolerance:e}"), none()],
                Rung::Fixed(_, h) => [format!("{h:e}"), none(), none()],
            };
            let (id, method) = (self.problem.id.clone(), rung.method().as_str().to_owned());
            let mut record = vec![id, method, sentences::setting(rung), step, rtol, points];
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
                    let why = sentences::refusal(self.problem, self.scene, refusal).join("; ");
                    record.extend([yes(false), yes(line.row.auto), why]);
                }
            }
            push_line(&mut out, &record);
        }
        String::from_utf8(out).unwrap_or_default()
    }

    /// Error against cost, one line for each method.
    pub fn plot(&self) -> LineChart {
        let point = |l: &MeasuredRow| {
            let y = worst(l).max(NO_ERROR);
            DataPoint { x: cost(l), y, filled: l.best, ringed: l.row.auto }
        };
        // What settles by itself is no point of a line.
        let (settled, of_methods): (Vec<_>, Vec<_>) =
            self.finite().partition(|l| l.row.rung == Rung::Settled);
        let series = Method::ALL.iter().enumerate().map(|(style, method)| {
            let of = of_methods.iter().filter(|l| l.row.rung.method() == *method);
            Series { name: method.as_str().to_owned(), style, points: of.map(|l| point(l)).collect() }
        });
        let settled = settled.iter();
        let settled =
            settled.map(|l| Series { name: "gauss, settled".to_owned(), style: 0, points: vec![point(l)] });
        let series: Vec<Series> = settled.chain(series).filter(|s| !s.points.is_empty()).collect();
        let points = || series.iter().flat_map(|s| &s.points);
        let label = if self.timed { "time of one solve, s" } else { "force evaluations of one solve" };
        let ys = points().map(|p| p.y).chain([NO_ERROR]);
        LineChart {
            caption: Caption::new(
                format!("error-{}", self.problem.id),
                format!("{}: error against cost", self.problem.title),
                self.described(),
            ),
            x: Axis::around(label, AxisScale::Log, points().map(|p| p.x)),
            y: Axis::around("greatest relative error of the asked answers", AxisScale::Log, ys),
            notes: ["filled: unbeaten", "ring: what auto takes", "bottom: no error"]
                .map(String::from)
                .to_vec(),
            series,
        }
    }

    /// The rows that have a place in a plot: what is not a number has none, least of all that of no error.
    fn finite(&self) -> impl Iterator<Item = &MeasuredRow> {
        self.lines.iter().filter(|l| worst(l).is_finite())
    }

    /// What the plot shows, for those who do not see it.
    fn described(&self) -> String {
        let best = |method: Method| {
            let of = self.lines.iter().filter(|l| l.row.rung.method() == method && l.row.found.is_ok());
            of.min_by(|a, b| worst(a).total_cmp(&worst(b)))
        };
        let told = |l: &MeasuredRow| {
            let unit = if self.timed { duration(cost(l)) } else { format!("{} evaluations", cost(l)) };
            format!("{} reaches {} in {unit}", l.row.rung.method().as_str(), short(worst(l)))
        };
        let list: Vec<String> = Method::ALL.iter().filter_map(|m| best(*m)).map(told).collect();
        let list = list.join("; ");
        format!("Greatest relative error of the asked answers against cost, both axes logarithmic. {list}.")
    }

    /// Delivered error against requested tolerance.
    fn tolerance_plot(&self) -> Option<LineChart> {
        let mut series = vec![Series { name: "as asked".to_owned(), style: 0, points: Vec::new() }];
        for (style, method) in Method::ALL.iter().enumerate() {
            let of = self.finite().filter(|l| l.row.rung.method() == *method);
            let point = |l: &MeasuredRow| {
                let x = l.row.rung.requested()?;
                Some(DataPoint { x, y: worst(l).max(NO_ERROR), filled: true, ringed: false })
            };
            let points: Vec<DataPoint> = of.filter_map(point).collect();
            if !points.is_empty() {
                series.push(Series { name: method.as_str().to_owned(), style, points });
            }
        }
        let xs: Vec<f64> = series.iter().flat_map(|s| s.points.iter().map(|p| p.x)).collect();
        let (low, high) = xs.iter().fold((f64::INFINITY, 0.0f64), |(l, h), x| (l.min(*x), h.max(*x)));
        if xs.len() < 2 {
            return None;
        }
        series[0].points = [low, high].map(|x| DataPoint { x, y: x, filled: false, ringed: false }).to_vec();
        let ys: Vec<f64> = series.iter().flat_map(|s| s.points.iter().map(|p| p.y)).collect();
        Some(LineChart {
            caption: Caption::new(
                format!("tolerance-{}", self.problem.id),
                "Error of the result against tolerance of a step",
                "Greatest relative error of the asked answers against the requested tolerance, both axes logarithmic.",
            ),
            x: Axis::around("requested tolerance", AxisScale::Log, xs.into_iter()),
            y: Axis::around("delivered error", AxisScale::Log, ys.into_iter().chain([NO_ERROR])),
            series,
            notes: vec!["bottom: no error".to_owned()],
        })
    }

    /// The page for a browser. Errors: a fault of its template.
    pub fn page(&self) -> Result<String, Findings> {
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
        view.value("head", template::list(self.head().iter().map(|t| text(t))));
        let mut before = None;
        let rows = self.lines.iter().map(|line| {
            let method = line.row.rung.method();
            let first = (before.replace(method) != Some(method)).then_some("first");
            let kind = if line.row.found.is_err() { Some("refused") } else { line.best.then_some("best") };
            let style: Vec<&str> = [first, kind].into_iter().flatten().collect();
            let cells = template::list(self.cells(line).iter().map(|t| text(t)));
            template::map([("style", text(&style.join(" "))), ("cells", cells)])
        });
        view.value("rows", template::list(rows));
        view.value("notes", template::list(self.refusals().iter().map(|t| text(t))));
        let out = Templates::english().made("accuracy.html", &view)?;
        Ok(String::from_utf8(out).unwrap_or_default())
    }
}
