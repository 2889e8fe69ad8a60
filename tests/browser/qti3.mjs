// node qti3.mjs ITEMS.json: items of QTI 3 in a player, in headless Chromium. The items and what each round of answers must score are
// made by `cargo test --test program exports::`, which starts this; playwright-core and @citolab/qti-components lie in the folder
// SLIPSTICK_BROWSER.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { createRequire } from 'node:module';

const folder = path.resolve(process.env.SLIPSTICK_BROWSER);
const { chromium } = createRequire(path.join(folder, 'package.json'))('playwright-core');
const player = fs.readFileSync(path.join(folder, 'node_modules/@citolab/qti-components/cdn/index.js'));
const items = JSON.parse(fs.readFileSync(process.argv[2], 'utf8'));
const faults = [];
const holds = (is, what) => { if (!is) faults.push(what); };

const server = http.createServer((request, response) => {
  const at = new URL(request.url, 'http://localhost').pathname;
  const send = (type, body) => { response.setHeader('content-type', type); response.end(body); };
  if (at === '/player.js') return send('text/javascript', player);
  const item = /^\/item-(\d+)\.xml$/.exec(at);
  if (item) return send('application/xml', fs.readFileSync(items[item[1]].file));
  // The figures are looked at elsewhere.
  if (at.endsWith('.svg')) return send('image/svg+xml', '<svg xmlns="http://www.w3.org/2000/svg"/>');
  return send('text/html', `<!doctype html><meta charset=utf-8><script type=module src=/player.js></script><qti-item><item-container item-url="/item-${at.slice(1)}.xml"></item-container></qti-item>`);
}).listen(0, '127.0.0.1');
await new Promise((ready) => server.once('listening', ready));

const browser = await chromium.launch({
  executablePath: process.env.SLIPSTICK_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--disable-sync', '--disable-component-update'],
});
const page = await browser.newPage();
page.on('pageerror', (error) => faults.push(String(error)));

let judged = 0;
for (const [i, { file, points, tries }] of items.entries()) {
  await page.goto(`http://127.0.0.1:${server.address().port}/${i}`);
  await page.waitForFunction(() => {
    const container = document.querySelector('item-container');
    const item = (container?.shadowRoot ?? container)?.querySelector('qti-assessment-item');
    return item?.variables?.some((variable) => variable.identifier === 'MAXSCORE');
  }, null, { timeout: 30000 });
  for (const { answers, score } of tries) {
    judged += Object.keys(answers).length;
    const told = await page.evaluate((answers) => {
      const container = document.querySelector('item-container');
      const item = (container.shadowRoot ?? container).querySelector('qti-assessment-item');
      for (const [part, answer] of Object.entries(answers)) {
        const text = item.querySelector(`qti-text-entry-interaction[response-identifier="${part}"]`);
        if (text) {
          const box = text.shadowRoot.querySelector('input');
          box.value = answer;
          for (const kind of ['input', 'change']) box.dispatchEvent(new Event(kind, { bubbles: true }));
          continue;
        }
        const choice = item.querySelector(`qti-inline-choice-interaction[response-identifier="${part}"]`);
        const words = [...choice.querySelectorAll('qti-inline-choice')].map((word) => word.getAttribute('identifier'));
        if (answer && !words.includes(answer)) throw new Error(`${answer} is not offered: ${words}`);
        choice.response = answer;
        choice.saveResponse(answer);
      }
      item.processResponse();
      return Object.fromEntries(item.variables.map((variable) => [variable.identifier, variable.value]));
    }, answers);
    const name = path.basename(file);
    holds(Number(told.MAXSCORE) === points, `${name}: MAXSCORE ${told.MAXSCORE}, not ${points}`);
    holds(Math.abs(Number(told.SCORE) - score) < 1e-9, `${name}: ${JSON.stringify(answers)} scores ${told.SCORE}, not ${score}: ${JSON.stringify(told)}`);
    for (const part of Object.keys(answers)) {
      holds(score === 0 ? Number(told[`SCORE-${part}`]) === 0 : Number(told[`SCORE-${part}`]) > 0, `${name}: ${part}=${JSON.stringify(answers[part])} scores ${told[`SCORE-${part}`]}`);
    }
  }
}
await browser.close();
server.close();
console.log(`${judged} answers in ${items.length} items`);
if (faults.length) {
  console.error(faults.slice(0, 20).join('\n'));
  console.error(`${faults.length} faults`);
  process.exit(1);
}
