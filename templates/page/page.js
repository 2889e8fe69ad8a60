'use strict';
// A sheet that checks itself. The program that answers is WebAssembly: from the page, or from beside it.
(async () => {
  const $ = (id) => document.getElementById(id);
  const data = JSON.parse($('sheet').textContent);
  const phrases = data.phrases.phrases;
  const say = (name, places = {}) => phrases[name].replace(/\{(\w+)\}/g, (all, place) => places[place] ?? all);
  const tell = (text) => { $('status').textContent = text; };
  const boxes = [...document.querySelectorAll('.box input')];
  const parts = new Map(boxes.map((box) => [box.name, box]));
  let program = null;

  // What the browser keeps; some keep nothing for files or in private windows.
  const kept = {
    get() { try { return JSON.parse(localStorage.getItem(data.keep)) ?? {}; } catch { return {}; } },
    put(answers) { try { localStorage.setItem(data.keep, JSON.stringify(answers)); return true; } catch { return false; } },
    drop() { try { localStorage.removeItem(data.keep); } catch { /* there is nothing to delete */ } },
  };
  const answers = () => Object.fromEntries(boxes.filter((box) => box.value.trim()).map((box) => [box.name, box.value]));

  // Below each box: how it is read, and what was found.
  const element = (name, place, id) => {
    const made = document.createElement('span');
    made.className = name;
    if (id) made.id = id;
    place.append(made);
    return made;
  };
  const below = new Map(boxes.map((box) => {
    const place = box.parentElement;
    const read = element('read', place, `read-${box.name}`);
    const found = element('found', place, `found-${box.name}`);
    found.hidden = true;
    const label = element('label', found);
    const reason = element('reason', found);
    reason.dataset.part = box.name;
    const hint = element('hint', found);
    box.setAttribute('aria-describedby', `${read.id} ${found.id}`);
    return [box.name, { read, found, label, reason, hint }];
  }));
  const forget = (name) => {
    const { found, reason } = below.get(name);
    found.hidden = true;
    for (const what of ['verdict', 'read', 'hint']) delete reason.dataset[what];
  };
  const echo = (name) => {
    const read = parts.get(name).value.trim() ? program?.({ read: [name, parts.get(name).value] }) : '';
    below.get(name).read.textContent = read ? say('page.read', { read }) : '';
  };
  const show = (told) => {
    const { found, label, reason, hint } = below.get(told.part);
    label.textContent = say(`report.verdict.${told.verdict.replaceAll(' ', '_')}`);
    reason.textContent = told.reason;
    hint.textContent = told.hint ?? '';
    found.dataset.verdict = told.verdict;
    Object.assign(reason.dataset, { read: told.read, hint: told.hint ?? '', verdict: told.verdict });
    found.hidden = false;
  };
  const fill = (given) => {
    for (const box of boxes) {
      box.value = given[box.name] ?? '';
      forget(box.name);
      echo(box.name);
    }
  };

  // The sheet's own words are suggested where a word is asked.
  for (const problem of data.sheet.problems) {
    for (const part of problem.parts) {
      const box = parts.get(`${problem.number}.${part.id}`);
      const words = data.words[`${problem.number}.${part.id}`];
      if (!box || !words) continue;
      const list = document.createElement('datalist');
      list.id = `words-${box.name}`;
      list.append(...words.map((word) => new Option(word, word)));
      box.after(list);
      box.setAttribute('list', list.id);
    }
  }
  document.documentElement.classList.add('runs');
  $('answers').hidden = false;
  document.querySelector('.tools').hidden = false;
  fill(kept.get());
  if (!kept.put(answers())) $('kept').textContent = say('page.not_kept');

  let undo = null;
  const settle = () => { undo = null; $('delete').textContent = say('page.delete'); };
  const keep = () => { if (!kept.put(answers())) $('kept').textContent = say('page.not_kept'); };
  for (const box of boxes) {
    box.addEventListener('input', () => { forget(box.name); echo(box.name); settle(); keep(); });
  }
  $('answers').addEventListener('submit', (event) => {
    event.preventDefault();
    if (!program) return;
    const filled = Object.entries(answers());
    const told = program({ check: filled });
    told.forEach(show);
    const right = told.filter((one) => one.verdict === 'right').length;
    tell(filled.length ? say('page.count', { right, n: filled.length }) : say('page.nothing'));
  });

  // A file of answers, a line for each. What a spreadsheet would run gets an apostrophe in front, as the program writes it.
  const guarded = (text) => (/^['\s]*[=+@-]/.test(text) && !/^[+-][\d.,]+( ?[a-z%°µ].*)?$/i.test(text) ? `'${text}` : text);
  const field = (text) => (/[",;\r\n]|^\s|\s$/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const { student } = data.sheet;
  $('save').addEventListener('click', () => {
    const saved = new Date().toISOString();
    const rows = Object.entries(answers()).map(([name, text]) => {
      const at = name.indexOf('.');
      return [student, name.slice(0, at), name.slice(at + 1), text, saved].map((one) => field(guarded(one))).join(',');
    });
    const text = ['student,problem,part,answer,saved_at', ...rows, ''].join('\r\n');
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob(['\ufeff', text], { type: 'text/csv' }));
    link.download = data.file;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    tell(say('page.saved', { file: data.file }));
  });
  const table = (text) => {
    const plain = text.replace(/^\ufeff/, '');
    const mark = [',', ';', '\t'].find((one) => plain.split(/\r?\n/, 1)[0].includes(one)) ?? ',';
    const rows = [[]];
    let cell = '', quoted = false;
    for (let i = 0; i < plain.length; i++) {
      const c = plain[i];
      if (quoted && c === '"' && plain[i + 1] === '"') { cell += '"'; i++; } else if (c === '"') quoted = !quoted;
      else if (!quoted && (c === mark || c === '\n')) {
        rows.at(-1).push(cell.replace(/\r$/, ''));
        cell = '';
        if (c === '\n') rows.push([]);
      } else cell += c;
    }
    rows.at(-1).push(cell);
    return rows.filter((row) => row.length > 1);
  };
  $('load').addEventListener('click', () => $('file').click());
  $('file').addEventListener('change', async () => {
    const [file] = $('file').files;
    if (!file) return;
    const [head = [], ...rows] = table(await file.text());
    $('file').value = '';
    const column = (name) => head.findIndex((one) => one.trim().toLowerCase() === name);
    const [who, problem, part, answer] = ['student', 'problem', 'part', 'answer'].map(column);
    if ([who, problem, part, answer].includes(-1)) return tell(say('page.not_a_file'));
    const other = rows.find((row) => row[who] !== student && row[who] !== `'${student}`);
    if (other) return tell(say('page.of_another', { student: other[who], own: student }));
    const given = rows.map((row) => [`${row[problem]}.${row[part]}`, row[answer].replace(/^'(?=['\s]*[=+@-])/, '')]);
    fill({ ...answers(), ...Object.fromEntries(given.filter(([name]) => parts.has(name))) });
    keep();
    settle();
    tell(say('page.loaded', { n: given.length }));
  });
  $('delete').addEventListener('click', () => {
    if (undo) { fill(undo); keep(); settle(); tell(say('page.ready')); return; }
    undo = answers();
    fill({});
    kept.drop();
    $('delete').textContent = say('page.undo');
    tell(say('page.deleted'));
  });

  // The program: packed in the page, or in a file beside it that the browser keeps for when there is no network.
  const packed = async () => {
    const here = $('program');
    if (here) return Uint8Array.from(atob(here.textContent.trim()), (c) => c.charCodeAt(0));
    if (location.protocol === 'file:') throw new Error(say('page.from_server'));
    if ('serviceWorker' in navigator) {
      await navigator.serviceWorker.register('../sw.js').then(() => caches.open('slipstick'))
        .then((cache) => cache.addAll([location.pathname, '../check.wasm.gz'])).catch(() => {});
    }
    const response = await fetch('../check.wasm.gz');
    if (!response.ok) throw new Error(String(response.status));
    return new Uint8Array(await response.arrayBuffer());
  };
  try {
    const unpacked = new Blob([await packed()]).stream().pipeThrough(new DecompressionStream('gzip'));
    const { instance: { exports } } = await WebAssembly.instantiate(await new Response(unpacked).arrayBuffer(), {});
    const call = (run, text) => {
      const bytes = new TextEncoder().encode(text);
      const at = exports.room(bytes.length);
      new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
      const length = run();
      return new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.place(), length));
    };
    const fault = call(exports.open, JSON.stringify({ sheet: data.sheet, phrases: data.phrases }));
    if (fault !== 'null') throw new Error(fault);
    program = (request) => JSON.parse(call(exports.ask, JSON.stringify(request)));
    for (const box of boxes) echo(box.name);
    tell(say('page.ready'));
  } catch (error) {
    tell(say('page.cannot', { why: error.message }));
  }
  document.documentElement.dataset.ready = program ? 'yes' : 'no';
})();
