// Chromium without a window, led over a pipe by its DevTools protocol. Whatever it logs as an error fails.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// The wrapper script in the path may read settings from elsewhere.
const program = ['/usr/lib/chromium/chromium', '/usr/bin/chromium'].find(existsSync);

export const drivers = {
    llvmpipe: ['--use-angle=gl-egl', '--ignore-gpu-blocklist'],
    swiftshader: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
};

const flags = [
    '--headless=new', '--no-sandbox', '--remote-debugging-pipe', '--no-first-run', '--disable-background-networking',
    '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1', '--force-device-scale-factor=1', '--hide-scrollbars',
];

// Messages end in a zero byte.
function* messagesOf(state, part) {
    state.text += part;
    for (let end = state.text.indexOf('\0'); end >= 0; end = state.text.indexOf('\0')) {
        yield JSON.parse(state.text.slice(0, end));
        state.text = state.text.slice(end + 1);
    }
}

// What a message says went wrong, or nothing.
function wrongIn({ method, params }) {
    const said = (args) => args.map((a) => a.value ?? a.description ?? '').join(' ');
    if (method === 'Runtime.exceptionThrown') {
        const { text, exception } = params.exceptionDetails;
        return `${text} ${exception?.description ?? ''}`;
    }
    if (method === 'Runtime.consoleAPICalled' && ['error', 'assert'].includes(params.type)) return said(params.args);
    const entry = params?.entry;
    if (method === 'Log.entryAdded' && entry.level === 'error') return `${entry.text} ${entry.url ?? ''}`;
    if (method === 'Inspector.targetCrashed') return 'the page crashed';
    return undefined;
}

export class Browser {
    // One page, ready to be led.
    static async open(driver) {
        const browser = new Browser(driver);
        try {
            await browser.until(browser.begin(), 60);
        } catch (error) {
            await browser.close();
            throw error;
        }
        return browser;
    }

    async begin() {
        const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
        const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
        this.session = sessionId;
        for (const domain of ['Runtime', 'Log', 'Page', 'Inspector']) await this.send(`${domain}.enable`);
    }

    constructor(driver) {
        this.profile = mkdtempSync(join(tmpdir(), 'claque-webgl-'));
        this.errors = [];
        this.waiting = new Map();
        this.failed = new Promise((_, refuse) => { this.refuse = refuse; });
        this.failed.catch(() => {});
        this.child = spawn(program, [...flags, ...drivers[driver], `--user-data-dir=${this.profile}`], {
            stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], detached: true,
            env: { ...process.env, HOME: this.profile },
        });
        this.ended = new Promise((keep) => this.child.on('exit', keep));
        this.ended.then((code) => this.refuse(new Error(`chromium ended with ${code}`)));
        const state = { text: '' };
        this.child.stdio[3].on('error', () => {});
        this.child.stdio[4].setEncoding('utf8').on('data', (part) => {
            for (const message of messagesOf(state, part)) this.take(message);
        });
    }

    take(message) {
        const wrong = wrongIn(message), waits = this.waiting.get(message.id);
        if (wrong) {
            this.errors.push(wrong);
            this.refuse(new Error(`the browser logs: ${wrong}`));
        }
        this.waiting.delete(message.id);
        if (message.error) waits?.refuse(new Error(message.error.message));
        else waits?.keep(message.result);
    }

    send(method, params = {}) {
        const id = ++Browser.messages;
        this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.session })}\0`);
        return Promise.race([this.failed, new Promise((keep, refuse) => this.waiting.set(id, { keep, refuse }))]);
    }

    // Waits for `done`, but not longer than `seconds`, and not if something went wrong.
    async until(done, seconds) {
        let timer;
        const late = new Promise((_, refuse) => {
            timer = setTimeout(() => refuse(new Error(`nothing came in ${seconds} seconds`)), 1000 * seconds);
        });
        try {
            return await Promise.race([done, this.failed, late]);
        } finally {
            clearTimeout(timer);
        }
    }

    async close() {
        try { process.kill(-this.child.pid, 'SIGKILL'); } catch { /* it has ended */ }
        await this.ended;
        rmSync(this.profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
    }
}
Browser.messages = 0;
