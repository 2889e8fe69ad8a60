#![allow(clippy::unwrap_used, clippy::print_stdout)]
mod support;
use slipstick::grade::judge::accepts;
use slipstick::key::Answer;
use slipstick::problem::make::Maker;
use slipstick::problem::make_key;
use slipstick::solution::by_hand;
use slipstick::words::Words;

fn fig(v: f64, n: usize) -> f64 {
    format!("{v:.*e}", n - 1).parse().unwrap()
}

#[test]
fn explore() {
    let n: u32 = std::env::var("N").ok().and_then(|t| t.parse().ok()).unwrap_or(300);
    let words = Words::english();
    for bank in support::banks() {
        for problem in bank.problems.iter().filter(|p| std::env::var("P").map_or(true, |f| f == p.id)) {
            let t0 = std::time::Instant::now();
            let maker = Maker::new(problem, 4, "scoring");
            let mut miss = vec![[0u32; 6]; problem.questions.len()];
            let mut seen = vec![[0u32; 6]; problem.questions.len()];
            let mut failed = 0;
            let mut errs: Vec<[Vec<(f64, f64, f64)>; 2]> = vec![Default::default(); problem.questions.len()];
            let mut tw = std::time::Duration::ZERO;
            let mut why = String::new();
            for student in 0..n {
                let v = maker.variant(&student.to_string()).unwrap();
                let key = make_key::key(problem, &v);
                let t1 = std::time::Instant::now();
                let r = by_hand::answers(problem, &v, &words, 3);
                tw += t1.elapsed();
                let hand = match r {
                    Ok(h) => h,
                    Err(e) => {
                        failed += 1;
                        why = e.to_string();
                        continue;
                    }
                };
                for h in hand {
                    let i = problem.questions.iter().position(|q| q.label == h.label).unwrap();
                    let Answer::Number { value, half_width, .. } = key.parts[i].answer else { continue };
                    let u = &problem.questions[i].unit;
                    let (ev, nv) = (h.eom.map(|r| r.value), h.energy.map(|r| r.value));
                    {
                        let x = h.value().unwrap();
                        let w = u.to_si(fig(u.from_si(x), 3));
                        miss[i][5] += u32::from(!accepts(w, value, half_width));
                    }
                    for (k, x) in [ev, nv].into_iter().enumerate() {
                        let Some(x) = x else { continue };
                        {
                            let w = u.to_si(fig(u.from_si(x), 3));
                            let c = key.parts[i].cond.unwrap();
                            let rel = (w - value).abs() / value.abs();
                            errs[i][k].push((rel, rel / c.max(1.0), (w - value).abs() / half_width));
                        }
                        for (j, f) in [3, 4].into_iter().enumerate() {
                            let w = u.to_si(fig(u.from_si(x), f));
                            seen[i][2 * k + j] += 1;
                            miss[i][2 * k + j] += u32::from(!accepts(w, value, half_width));
                            if k == 0 && j == 0 && (w - value).abs() > 0.5 * half_width {
                                miss[i][4] += 1;
                            }
                        }
                    }
                }
            }
            println!(
                "{} {:.1}s, by hand {:.1}s, failed {failed} {why}",
                problem.id,
                t0.elapsed().as_secs_f64(),
                tw.as_secs_f64()
            );
            for (i, q) in problem.questions.iter().enumerate() {
                println!(
                    "   {:22} eom {:4} {:5.2} {:5.2} % energy {:4} {:5.2} {:5.2}   half {:5.1}  {:?}  TAKEN {:5.2}",
                    q.id,
                    seen[i][0],
                    100.0 * miss[i][0] as f64 / seen[i][0] as f64,
                    100.0 * miss[i][1] as f64 / seen[i][1] as f64,
                    seen[i][2],
                    100.0 * miss[i][2] as f64 / seen[i][2] as f64,
                    100.0 * miss[i][3] as f64 / seen[i][3] as f64,
                    100.0 * miss[i][4] as f64 / seen[i][0] as f64,
                    q.relative.fixed(),
                    100.0 * miss[i][5] as f64 / seen[i][0] as f64
                );
                for e in &errs[i] {
                    let q = |f: &dyn Fn(&(f64, f64, f64)) -> f64, p: f64| {
                        let mut v: Vec<f64> = e.iter().map(f).collect();
                        v.sort_by(f64::total_cmp);
                        v.get(((v.len() as f64) * p) as usize).copied().unwrap_or(f64::NAN)
                    };
                    println!(
                        "         rel 99 {:5.2} % 99.8 {:5.2} %   per cond 99 {:5.2} 99.8 {:5.2}   halfwidths 99.8 {:5.2}",
                        100.0 * q(&|x| x.0, 0.99),
                        100.0 * q(&|x| x.0, 0.998),
                        100.0 * q(&|x| x.1, 0.99),
                        100.0 * q(&|x| x.1, 0.998),
                        q(&|x| x.2, 0.998)
                    );
                }
            }
        }
    }
}
