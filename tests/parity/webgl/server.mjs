// Gives a page its files and those of a scene, and writes what it sends back into a folder.
import { mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { basename, dirname, join, resolve } from 'node:path';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json' };
const arrays = ['positions', 'normals', 'colour', 'depth', 'actor', 'zone', 'actors', 'sizes', 'model_view'];
const takes = ['capture.json', ...arrays.map((name) => `${name}.npy`)];

async function bodyOf(request) {
    const parts = [];
    for await (const part of request) parts.push(part);
    return Buffer.concat(parts);
}

// `folders`: which folder each first part of a path means, '' for the page's own. `edit(name, text)` may change a file
// that the page asks for. Answers with the address, and a promise that is kept when the result is complete.
export async function serve(folders, result, edit = (name, text) => text) {
    const place = resolve(result);
    const partial = join(dirname(place), `.${basename(place)}.${process.pid}`);
    mkdirSync(partial, { recursive: true });
    let isComplete;
    const complete = new Promise((keep) => { isComplete = keep; });

    const give = (path, answer) => {
        const [first, ...rest] = path.split('/').slice(1);
        const folder = rest.length ? folders[first] : folders[''], name = rest.length ? rest.join('/') : first;
        if (!folder || path.includes('..')) return answer.writeHead(404).end();
        const bytes = readFileSync(join(folder, name || 'index.html'));
        const type = types[/\.\w+$/.exec(name || 'index.html')?.[0]] ?? 'application/octet-stream';
        const body = type === 'text/javascript' ? edit(name, `${bytes}`) : bytes;
        answer.writeHead(200, { 'content-type': type }).end(body);
    };
    const take = async (name, request, answer) => {
        const body = await bodyOf(request);
        if (takes.includes(name)) writeFileSync(join(partial, name), body);
        else if (name !== 'complete') return answer.writeHead(400).end(`a result has no ${name}`);
        answer.writeHead(200).end();
        if (name !== 'complete') return;
        rmSync(place, { recursive: true, force: true });
        renameSync(partial, place);
        isComplete();
    };
    const server = createServer((request, answer) => {
        const path = decodeURIComponent(request.url.split('?')[0]);
        const done = request.method === 'POST' && path.startsWith('/result/')
            ? take(path.slice('/result/'.length), request, answer) : (async () => give(path, answer))();
        done.catch((error) => answer.writeHead(404).end(error.message));
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    const close = () => {
        server.closeAllConnections();
        server.close();
        rmSync(partial, { recursive: true, force: true });
    };
    return { address: `http://127.0.0.1:${server.address().port}/`, complete, close };
}
