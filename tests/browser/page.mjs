// node page.mjs CASES.json: sheets that check themselves, in headless Chromium. The cases and what must come out are made by
// `cargo test --test program page::`, which starts this; playwright-core and axe-core lie in the folder MODULES.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { createRequire } from 'node:module';

const modules = createRequire(path.join(path.resolve(process.env.SLIPSTICK_BROWSER), 'package.json'));
const { chromium } = modules('playwright-core');
const axe = fs.readFileSync(modules.resolve('axe-core/axe.min.js'), 'utf8');
const { sheets, site, off, practice, hints } = JSON.parse(fs.readFileSync(process.argv[2], 'utf8'));
const faults = [];
const holds = (is, what) => { if (!is) faults.push(what); };

const browser = await chromium.launch({
  executablePath: process.env.SLIPSTICK_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--disable-sync', '--disable-component-update'],
});
const opened = async (url, settings = {}) => {
  const context = await browser.newContext({ viewport: { width: 390, height: 844 }, acceptDownloads: true, ...settings });
  const page = await context.newPage();
  page.on('console', (message) => { if (message.type() === 'error' && !/ERR_(CONNECTION|INTERNET)/.test(message.text())) faults.push(`${url}: ${message.text()}`); });
  page.on('pageerror', (error) => faults.push(`${url}: ${error}`));
  page.on('request', (request) => holds(settings.server || /^(file|data|blob):/.test(request.url()), `${url}: fetches ${request.url()}`));
  await page.goto(url);
  return page;
};
const ready = (page) => page.waitForFunction(() => document.documentElement.dataset.ready === 'yes', null, { timeout: 30000 });
const box = (page, part) => page.locator(`input[name="${part}"]`);
const found = (page) => page.$$eval('[data-part]', (all) => all.map((e) => ({ part: e.dataset.part, verdict: e.dataset.verdict, read: e.dataset.read, hint: e.dataset.hint, reason: e.textContent })));
const sound = async (page, what) => {
  if (!await page.evaluate(() => 'axe' in window)) await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'] }));
  for (const v of violations) faults.push(`${what}: ${v.id}: ${v.help}: ${v.nodes.map((n) => n.target).join(' ').slice(0, 300)}`);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  holds(wide <= 0, `${what}: scrolls sideways by ${wide} px`);
};
const url = (file) => `file://${encodeURI(path.resolve(file))}`;

let judged = 0, hinted = 0, slowest = 0;
const rounds = async (sheet) => {
  const page = await opened(url(sheet.file));
  await ready(page);
  const names = await page.$$eval('.box input', (all) => all.map((e) => e.name));
  holds(JSON.stringify(names.toSorted()) === JSON.stringify(sheet.parts.toSorted()), `${sheet.file}: boxes ${names}`);
  const button = page.getByRole('button', { name: sheet.button }).first();
  // No hint to a part is said twice.
  const said = new Map(names.map((part) => [part, new Set()]));
  for (const round of sheet.rounds) {
    await page.evaluate((cells) => {
      for (const box of document.querySelectorAll('.box input')) {
        box.value = cells[box.name] ?? '';
        box.dispatchEvent(new Event('input', { bubbles: true }));
      }
    }, Object.fromEntries(round.map((one) => [one.part, one.cell])));
    slowest = Math.max(slowest, await button.evaluate((one) => {
      const begin = performance.now();
      one.click();
      return performance.now() - begin;
    }));
    const told = (await found(page)).filter((one) => one.verdict);
    const wanted = round.filter((one) => one.cell.trim());
    holds(told.length === wanted.length, `${sheet.file}: ${told.length} verdicts for ${wanted.length} answers`);
    for (const want of wanted) {
      judged += 1;
      const got = told.filter((one) => one.part === want.part);
      for (const what of ['verdict', 'reason', 'read']) {
        holds(got.length === 1 && got[0][what] === want[what], `${sheet.file}: ${want.part}=${JSON.stringify(want.cell)}: ${what} ${JSON.stringify(got[0]?.[what])}, the program says ${JSON.stringify(want[what])}`);
      }
      const hint = want.hints.find((one) => !said.get(want.part).has(one));
      if (hint) said.get(want.part).add(hint);
      const line = hint ?? (want.hints.length ? sheet.no_more.replace('{part}', want.part).replace('{of}', want.hints.length) : '');
      hinted += hint ? 1 : 0;
      holds(got[0]?.hint === line, `${sheet.file}: ${want.part}=${JSON.stringify(want.cell)}: hint ${JSON.stringify(got[0]?.hint)}, the program says ${JSON.stringify(line)}`);
    }
  }
  await page.context().close();
};

// The ladder of one wrong answer: check again, or the button, and never twice.
const ladder = async (sheet) => {
  const page = await opened(url(sheet.file));
  await ready(page);
  const { part, cell, hints } = sheet.rounds.slice(2, 6).flat().toSorted((a, b) => b.hints.length - a.hints.length)[0];
  const told = async () => (await found(page)).find((one) => one.part === part).hint;
  await box(page, part).fill(cell);
  await box(page, part).press('Enter');
  const heard = [await told()];
  const more = page.locator(`#found-${part.replace('.', '\\.')} button`);
  for (let i = 1; i < hints.length; i++) {
    if (i % 2) await more.click();
    else await page.getByRole('button', { name: sheet.button }).first().click();
    heard.push(await told());
  }
  holds(JSON.stringify(heard) === JSON.stringify(hints) && hints.length > 2, `${sheet.file}: ${part}=${cell}: ${JSON.stringify(heard)}, the program says ${JSON.stringify(hints)}`);
  holds(!await more.isVisible(), `${sheet.file}: there is still a button for hints`);
  holds(await page.locator('.hint').count() === hints.length, `${sheet.file}: hints that were said stay`);
  await sound(page, `${sheet.file} with hints`);
  await page.context().close();
};

// One sheet as a student has it in hand: narrow, dark, by keyboard, kept, saved, read back, deleted.
const [{ file, parts: [first], rounds: [[{ cell }]], button, answers }] = sheets;
const screens = [{ viewport: { width: 360, height: 740 } }, { colorScheme: 'dark' }, { viewport: { width: 1280, height: 900 } }];
const screen = async (settings) => {
  const page = await opened(url(file), settings);
  await ready(page);
  await sound(page, `${file} ${JSON.stringify(settings)}`);
  for (const [i, name] of (await page.$$eval('.box input', (all) => all.map((e) => e.name))).entries()) await box(page, name).fill(i % 3 === 1 ? '1e9 kg' : i % 3 ? '0.1234' : cell);
  await page.getByRole('button', { name: button }).first().click();
  await sound(page, `${file} checked ${JSON.stringify(settings)}`);
  await page.context().close();
};
const by_keyboard = async () => {
  const page = await opened(url(file));
  await ready(page);
  const focused = () => page.evaluate(() => document.activeElement.name ?? '');
  for (let i = 0; i < 60 && await focused() !== first; i++) await page.keyboard.press('Tab');
  holds(await focused() === first, `${file}: the first box is not reached by keyboard`);
  await page.keyboard.type(cell);
  await page.keyboard.press('Enter');
  holds((await found(page)).find((one) => one.part === first).verdict === 'right', `${file}: Enter does not check`);
  await page.reload();
  await ready(page);
  holds(await box(page, first).inputValue() === cell, `${file}: not kept`);
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#save').click()]);
  holds(download.suggestedFilename() === answers, `${file}: saved as ${download.suggestedFilename()}`);
  const saved = await download.path();
  await page.locator('#delete').click();
  await page.reload();
  await ready(page);
  holds(await box(page, first).inputValue() === '', `${file}: not deleted`);
  await page.locator('#file').setInputFiles(saved);
  await page.waitForFunction((name) => document.querySelector(`input[name="${name}"]`).value !== '', first);
  holds(await box(page, first).inputValue() === cell, `${file}: not read back`);
  await page.emulateMedia({ media: 'print' });
  holds(!await page.locator('#answers').isVisible() && !await page.locator('.tools').isVisible(), `${file}: buttons are printed`);
  await page.context().close();
};
const without_scripts = async () => {
  const page = await opened(url(file), { javaScriptEnabled: false });
  holds(!await box(page, first).isVisible() && !await page.locator('#answers').isVisible(), `${file}: boxes without scripts`);
  holds(await page.locator('noscript').isVisible(), `${file}: nothing is said without scripts`);
  await page.context().close();
};

// A site: over the network once, then with the server gone.
const served = async () => {
  const types = { '.html': 'text/html', '.js': 'text/javascript', '.gz': 'application/octet-stream' };
  const server = http.createServer((request, response) => {
    const asked = path.join(site.folder, decodeURIComponent(request.url));
    if (!fs.existsSync(asked)) { response.writeHead(404).end(); return; }
    response.setHeader('content-type', types[path.extname(asked)] ?? 'application/octet-stream');
    response.end(fs.readFileSync(asked));
  }).listen(0, '127.0.0.1');
  await new Promise((done) => server.once('listening', done));
  const page = await opened(`http://127.0.0.1:${server.address().port}/${site.sheet}`, { server: true });
  const once = async (when) => {
    await ready(page);
    await box(page, site.part).fill(site.cell);
    await page.getByRole('button', { name: 'Check' }).first().click();
    holds((await found(page)).find((one) => one.part === site.part).verdict === 'right', `site ${when}: not checked`);
  };
  await once('with its server');
  await page.evaluate(() => navigator.serviceWorker.ready);
  server.closeAllConnections();
  await new Promise((done) => server.close(done));
  await page.reload();
  await once('without its server');
  await page.context().close();
};

// Practice: one problem at a time; the first is missed, and comes again behind the others, empty.
const practised_on = async (settings) => {
  const page = await opened(url(practice.file), settings);
  await ready(page);
  await sound(page, `practice ${JSON.stringify(settings)}`);
  await box(page, practice.tasks[0][0][0]).fill('0.1234');
  await page.keyboard.press('Enter');
  await page.locator('.task:not([hidden]) summary').click();
  await sound(page, `practice with a solution ${JSON.stringify(settings)}`);
  await page.context().close();
};
const practised = async () => {
  const [first, ...others] = practice.tasks;
  const page = await opened(url(practice.file));
  await ready(page);
  const shown = () => page.$$eval('.task:not([hidden]) .box input', (all) => all.map((e) => e.name));
  const at = async (task, what) => {
    const names = await shown();
    holds(JSON.stringify(names) === JSON.stringify(task.map(([name]) => name)), `practice: ${what}: boxes ${names}`);
  };
  const solve = async (task) => {
    for (const [name, right] of task) await box(page, name).fill(right);
    await page.locator('#answers button').first().click();
    const wrong = (await found(page)).filter((one) => one.verdict && one.verdict !== 'right');
    holds(wrong.length === 0, `practice: ${JSON.stringify(wrong)}`);
  };
  const next = async () => {
    await page.locator('#next').focus();
    await page.keyboard.press('Enter');
  };
  await at(first, 'at first');
  holds(!await page.locator('.task:not([hidden]) details > :not(summary)').first().isVisible(), 'practice: the solution is open');
  await box(page, first[0][0]).fill('0.1234');
  await page.keyboard.press('Enter');
  holds((await found(page)).find((one) => one.part === first[0][0]).hint !== '', 'practice: no hint');
  await next();
  await at(others[0], 'after one that was missed');
  await solve(others[0]);
  await page.reload();
  await ready(page);
  await at(others[0], 'after a reload');
  holds(await box(page, others[0][0][0]).inputValue() === others[0][0][1], 'practice: not kept');
  await next();
  await solve(others[1]);
  // A problem whose solution was opened comes again as well.
  await page.locator('.task:not([hidden]) summary').press('Enter');
  await next();
  await solve(others[2]);
  await next();
  for (const task of [first, others[1]]) {
    await at(task, 'what comes again');
    holds(await box(page, task[0][0]).inputValue() === '', 'practice: what comes again is not empty');
    holds(await page.locator('.task:not([hidden]) details[open]').count() === 0, 'practice: a solution is still open');
    await solve(task);
    await next();
  }
  holds((await shown()).length === 0 && /^All 4/.test(await page.locator('#status').textContent()), 'practice: no end');
  await sound(page, 'practice at its end');
  await page.locator('#over').click();
  await at(first, 'started over');
  await page.context().close();
};
const without_check = async () => {
  const page = await opened(url(off));
  holds(await page.locator('input, script, button').count() === 0, `${off}: self check is off`);
  await page.context().close();
};

// Two pages are open at a time, each a process of its own: what is long comes first.
const left = [
  practised, by_keyboard, served,
  ...sheets.map((sheet) => () => rounds(sheet)), ...sheets.slice(0, sheets.length / 3).map((sheet) => () => ladder(sheet)),
  ...screens.map((settings) => () => screen(settings)), ...screens.slice(0, 2).map((settings) => () => practised_on(settings)),
  without_scripts, without_check,
].values();
const lane = async () => { for (const task of left) await task(); };
await Promise.all([lane(), lane()]);
holds(hinted > hints, `only ${hinted} hints`);
await browser.close();
console.log(`${judged} answers and ${hinted} hints in ${sheets.length} pages; the slowest check took ${slowest.toFixed(0)} ms`);
for (const fault of faults.slice(0, 40)) console.error(fault);
process.exit(faults.length ? 1 : 0);
