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
  const keeper = (key) => ({
    get() { try { return JSON.parse(localStorage.getItem(key)) ?? {}; } catch { return {}; } },
    put(what) { try { localStorage.setItem(key, JSON.stringify(what)); return true; } catch { return false; } },
    drop() { try { localStorage.removeItem(key); } catch { /* there is nothing to delete */ } },
  });
  const kept = keeper(data.keep);
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
    const hints = element('hints', found);
    hints.setAttribute('aria-live', 'polite');
    const more = document.createElement('button');
    more.type = 'button';
    more.textContent = say('page.more');
    more.setAttribute('aria-label', say('page.more_of', { part: box.name }));
    more.addEventListener('click', () => lead(box.name));
    found.append(more);
    box.setAttribute('aria-describedby', `${read.id} ${found.id}`);
    return [box.name, { read, found, label, reason, hints, more, said: new Set(), told: null }];
  }));
  const forget = (name) => {
    const { found, reason } = below.get(name);
    below.get(name).told = null;
    found.hidden = true;
    for (const what of ['verdict', 'read', 'hint']) delete reason.dataset[what];
  };
  const echo = (name) => {
    const read = parts.get(name).value.trim() ? program?.({ read: [name, parts.get(name).value] }) : null;
    below.get(name).read.textContent = read ? say(read.readable ? 'page.read' : 'page.unread', { read: read.text }) : '';
  };
  // Indices are small and set off as such: v_0.
  const written = (text) => text.split(/(\p{L})_(\p{L}|\d)/u).map((piece, i) => {
    if (i % 3 < 2) return piece;
    const index = document.createElement('sub');
    index.textContent = piece;
    return index;
  });
  // Each hint to a part is said once, whatever answers it leads on from; those to the answer that stands in the box stay there.
  const lead = (name) => {
    const { reason, hints, more, said, told } = below.get(name);
    const all = told.hints;
    const next = all.find((text) => !said.has(text));
    if (next !== undefined) said.add(next);
    hints.replaceChildren();
    all.forEach((hint, i) => {
      if (said.has(hint)) element('hint', hints).append(...written(say('page.hint', { n: i + 1, of: all.length, hint })));
    });
    const left = all.some((text) => !said.has(text));
    if (!left && next === undefined && all.length) element('hint', hints).textContent = say('page.all_said');
    // The focus does not fall to the begin of the page with the button.
    if (!left && document.activeElement === more) parts.get(name).focus();
    more.hidden = !left;
    reason.dataset.hint = next ?? (all.length ? say('tutor.no_more', { part: name, of: all.length }) : '');
  };
  const show = (told) => {
    const place = below.get(told.part);
    const { found, label, reason } = place;
    label.textContent = say(`report.verdict.${told.verdict.replaceAll(' ', '_')}`);
    reason.textContent = told.reason;
    found.dataset.verdict = told.verdict;
    Object.assign(reason.dataset, { read: told.read, verdict: told.verdict });
    place.told = told;
    lead(told.part);
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
  for (const [part, words] of Object.entries(data.words)) {
    const box = parts.get(part);
    if (!box) continue;
    const list = document.createElement('datalist');
    list.id = `words-${box.name}`;
    list.append(...words.map((word) => new Option(word, word)));
    box.after(list);
    box.setAttribute('list', list.id);
  }
  document.documentElement.classList.add('runs');
  $('answers').hidden = false;
  document.querySelector('.tools').hidden = false;
  fill(kept.get());
  const tasks = [...document.querySelectorAll('.task')];
  const keep = () => { if (!kept.put(answers())) $('kept').textContent = say(tasks.length ? 'page.not_kept_practice' : 'page.not_kept'); };
  keep();
  tasks.forEach((task, i) => { task.hidden = i > 0; });

  let undo = null;
  const settle = () => { undo = null; if ($('delete')) $('delete').textContent = say('page.delete'); };
  for (const box of boxes) {
    box.addEventListener('input', () => { forget(box.name); echo(box.name); settle(); keep(); tell(''); });
  }
  $('answers').addEventListener('submit', (event) => {
    event.preventDefault();
    if (!program) return;
    const filled = Object.entries(answers()).filter(([name]) => !parts.get(name).closest('[hidden]'));
    const told = program({ check: filled });
    // What is checked again without a change anywhere asks for the next hint; beside another answer that is new it stays as it is.
    const changed = told.some((one) => !below.get(one.part).told);
    told.filter((one) => !changed || !below.get(one.part).told).forEach(show);
    const right = told.filter((one) => one.verdict === 'right').length;
    tell(filled.length ? say('page.count', { right, n: filled.length }) : say('page.nothing'));
  });

  // A file of answers, a line for each. What a spreadsheet would run gets an apostrophe in front, as the program writes it.
  const filing = () => {
    const guarded = (text) => (/^['\s]*[=+@-]/.test(text) && !/^[+-][\d.,]+( ?[a-z%°µ].*)?$/i.test(text) ? `'${text}` : text);
    const field = (text) => (/[",;\r\n]|^\s|\s$/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const { student, set } = data;
    $('save').addEventListener('click', () => {
      const saved = new Date().toISOString();
      const rows = Object.entries(answers()).map(([name, text]) => {
        const at = name.indexOf('.');
        return [student, name.slice(0, at), name.slice(at + 1), text, saved, set].map((one) => field(guarded(one))).join(',');
      });
      const text = ['student,problem,part,answer,saved_at,set', ...rows, ''].join('\r\n');
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
      const from = column('set');
      const foreign = rows.map((row) => row[from]).find((one) => one && one !== set && one !== `'${set}`);
      if (foreign) return tell(say('page.of_another_set', { set: foreign, own: set }));
      const given = rows.map((row) => [`${row[problem]}.${row[part]}`, row[answer].replace(/^'(?=['\s]*[=+@-])/, '')]);
      fill({ ...answers(), ...Object.fromEntries(given.filter(([name]) => parts.has(name))) });
      keep();
      settle();
      tell(say('page.loaded', { n: given.filter(([name]) => parts.has(name)).length }));
    });
    $('delete').addEventListener('click', () => {
      if (undo) { fill(undo); keep(); settle(); tell(say('page.ready')); return; }
      undo = answers();
      fill({});
      kept.drop();
      $('delete').textContent = say('page.undo');
      tell(say('page.deleted'));
    });
  };

  // Practice: one problem at a time. One that is passed on before all of it is right, or whose solution was opened, comes again after all others.
  const practise = (open) => {
    const order = keeper(`${data.keep} order`);
    const fresh = () => ({ queue: tasks.map((_, i) => i), looked: false });
    let state = order.get();
    const valid = Array.isArray(state.queue) && state.queue.every((i) => tasks[i]) && new Set(state.queue).size === state.queue.length;
    if (!valid) state = fresh();
    const solution = (task) => task.querySelector('details');
    const inside = (task) => boxes.filter((box) => task.contains(box));
    const turn = (say_it, focus) => {
      order.put(state);
      const [now] = state.queue;
      tasks.forEach((task, i) => { task.hidden = i !== now; });
      $('next').hidden = now === undefined;
      document.querySelector('#answers button').hidden = now === undefined;
      const counts = { all: tasks.length, solved: tasks.length - state.queue.length };
      if (now === undefined) return tell(say('page.finished', counts));
      open([data.problems[now]]);
      for (const box of inside(tasks[now])) echo(box.name);
      tell(say(say_it, counts));
      if (!focus) return;
      const title = tasks[now].querySelector('h2') ?? tasks[now];
      title.tabIndex = -1;
      title.focus();
      scrollTo(0, 0);
    };
    tasks.forEach((task) => solution(task).addEventListener('toggle', () => {
      if (!solution(task).open) return;
      state.looked = true;
      order.put(state);
    }));
    // A problem that comes again is as it was at first.
    const clear = (task) => {
      for (const box of inside(task)) {
        box.value = '';
        forget(box.name);
        below.get(box.name).said.clear();
        echo(box.name);
      }
      solution(task).open = false;
      keep();
    };
    $('next').addEventListener('click', () => {
      const now = state.queue.shift();
      const own = inside(tasks[now]);
      const told = program({ check: own.map((box) => [box.name, box.value]) });
      const missed = state.looked || told.some((one) => one.verdict !== 'right');
      if (missed) {
        state.queue.push(now);
        clear(tasks[now]);
      }
      state.looked = false;
      turn(missed ? 'page.again' : 'page.progress', true);
    });
    $('over').addEventListener('click', () => {
      state = fresh();
      tasks.forEach(clear);
      turn('page.progress', true);
    });
    turn('page.progress', false);
  };

  // The program: packed in the page, or in a file beside it that the browser keeps for when there is no network.
  const told = (name) => Object.assign(new Error(name), { told: say(name) });
  const packed = async () => {
    const here = $('program');
    if (here) return Uint8Array.from(atob(here.textContent.trim()), (c) => c.charCodeAt(0));
    if (location.protocol === 'file:') throw told('page.from_server');
    if ('serviceWorker' in navigator) {
      await navigator.serviceWorker.register('../sw.js').then(() => caches.open('slipstick'))
        .then((cache) => cache.addAll([location.pathname, `../${data.program}`])).catch(() => {});
    }
    const response = await fetch(`../${data.program}`);
    if (!response.ok) throw told('page.no_program');
    return new Uint8Array(await response.arrayBuffer());
  };
  if (!tasks.length) filing();
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
    const open = (problems) => {
      const fault = call(exports.open, JSON.stringify({ ...data, problems }));
      if (fault !== 'null') throw new Error(fault);
    };
    program = (request) => JSON.parse(call(exports.ask, JSON.stringify(request)));
    if (tasks.length) {
      practise(open);
    } else {
      open(data.problems);
      for (const box of boxes) echo(box.name);
      tell(say('page.ready'));
    }
  } catch (error) {
    tasks.forEach((task) => { task.hidden = false; });
    if (tasks.length) $('next').hidden = true;
    tell(error.told ?? say('page.cannot', { why: error.message }));
  }
  document.documentElement.dataset.ready = program ? 'yes' : 'no';
})();
