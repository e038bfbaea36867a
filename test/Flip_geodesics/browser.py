# SPDX-License-Identifier: LGPL-3.0-or-later
"""A page in a headless Chromium, driven by pointer, touch and keyboard through the browser's protocol of debugging."""

import json
import select
import subprocess
import time

PATIENCE = 120  # seconds, for the browser to do what it is waited for; nothing that is checked depends on it

KEYS = {'Enter': 13, 'Escape': 27, 'ArrowLeft': 37, 'ArrowUp': 38, 'ArrowRight': 39, 'ArrowDown': 40, 'Insert': 45, 'Delete': 46,
        'Tab': 9, 'Backspace': 8}
CTRL, SHIFT = 2, 8


class Browser:
    """Opens a page from a file. `early` is a script that runs before those of the page."""

    def __init__(self, executable, page, folder, size, early=''):
        self.folder = folder
        self.failures = []
        self._next, self._pending = 0, b''
        flags = ['--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-first-run',
                 '--disable-background-networking', '--disable-component-update', '--disable-sync', '--remote-debugging-pipe',
                 f'--user-data-dir={folder / "profile"}', 'about:blank']
        # The browser reads from descriptor 3 and writes to descriptor 4.
        self._process = subprocess.Popen(['/bin/sh', '-c', 'exec "$0" "$@" 3<&0 4>&1 < /dev/null > /dev/null 2>&1', executable, *flags],
                                         stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self._session = None
        (target,) = [t for t in self.call('Target.getTargets')['targetInfos'] if t['type'] == 'page']
        self._session = self.call('Target.attachToTarget', targetId=target['targetId'], flatten=True)['sessionId']
        for domain in ('Runtime', 'Page', 'DOM'):
            self.call(f'{domain}.enable')
        self.call('Browser.setDownloadBehavior', behavior='allow', downloadPath=str(folder))
        self.call('Page.addScriptToEvaluateOnNewDocument', source=early)
        self.resize(*size)
        self.call('Page.navigate', url=page.resolve().as_uri())

    def close(self):
        self._process.terminate()
        self._process.wait()

    def call(self, method, **parameters):
        self._next += 1
        message = {'id': self._next, 'method': method, 'params': parameters}
        if self._session:
            message['sessionId'] = self._session
        self._process.stdin.write(json.dumps(message).encode() + b'\0')
        while True:
            answer = self._read()
            if answer.get('method') == 'Runtime.exceptionThrown':
                self.failures.append(answer['params']['exceptionDetails'])
            if answer.get('id') == self._next:
                if 'error' in answer:
                    raise SystemExit(f'{method}: {answer["error"]}')
                return answer['result']

    def _read(self):
        while b'\0' not in self._pending:
            ready, _, _ = select.select([self._process.stdout], [], [], PATIENCE)
            piece = self._process.stdout.read(1 << 20) if ready else b''
            if not piece:
                raise SystemExit('the browser does not answer')
            self._pending += piece
        message, self._pending = self._pending.split(b'\0', 1)
        return json.loads(message)

    def evaluate(self, expression):
        result = self.call('Runtime.evaluate', expression=expression, awaitPromise=True, returnByValue=True)
        if 'exceptionDetails' in result:
            raise SystemExit(f'{expression}: {result["exceptionDetails"]}')
        return result['result'].get('value')

    def wait_for(self, expression):
        end = time.monotonic() + PATIENCE
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise SystemExit(f'{expression} does not become true: {self.evaluate("({...document.documentElement.dataset})")}')
            time.sleep(0.02)

    def text(self, selector):
        return self.evaluate(f'document.querySelector({json.dumps(selector)}).textContent')

    def texts(self, selector):
        return self.evaluate(f'Array.from(document.querySelectorAll({json.dumps(selector)}), (e) => e.textContent)')

    def resize(self, width, height):
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=False)

    def middle_of(self, selector):
        """Where in the window an element is, which is scrolled to."""
        return self.evaluate(f'''(() => {{
            const element = document.querySelector({json.dumps(selector)});
            element.scrollIntoView({{ block: 'nearest' }});
            const box = element.getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2];
        }})()''')

    def mouse(self, kind, x, y, modifiers=0, button='left'):
        self.call('Input.dispatchMouseEvent', type=kind, x=x, y=y, modifiers=modifiers, clickCount=1,
                  button=button, buttons=0 if kind == 'mouseReleased' else {'left': 1, 'right': 2, 'none': 0}[button])

    def click(self, x, y, modifiers=0, button='left'):
        self.mouse('mouseMoved', x, y, button='none')
        self.mouse('mousePressed', x, y, modifiers, button)
        self.mouse('mouseReleased', x, y, modifiers, button)

    def touch(self, x, y):
        self.swipe([(x, y)])

    def swipe(self, places):
        """Touches at the first place, and moves to the others."""
        for i, (x, y) in enumerate(places):
            self.call('Input.dispatchTouchEvent', type='touchMove' if i else 'touchStart', touchPoints=[{'x': x, 'y': y}])
        self.call('Input.dispatchTouchEvent', type='touchEnd', touchPoints=[])

    def press(self, key, modifiers=0):
        code = KEYS.get(key) or ord(key.upper())
        event = {'key': key, 'modifiers': modifiers, 'windowsVirtualKeyCode': code}
        text = {'Enter': '\r'}.get(key, key if len(key) == 1 and not modifiers & CTRL else '')
        self.call('Input.dispatchKeyEvent', type='keyDown', **event, **({'text': text} if text else {}))
        self.call('Input.dispatchKeyEvent', type='keyUp', **event)

    def type(self, selector, text):
        """Replaces what is in an input by the keyboard."""
        self.click(*self.middle_of(selector))
        self.evaluate(f'document.querySelector({json.dumps(selector)}).select()')
        self.press('Delete')
        self.call('Input.insertText', text=text)
        self.press('Enter')
        self.press('Tab')

    def choose_file(self, selector, path):
        element = self.call('Runtime.evaluate', expression=f'document.querySelector({json.dumps(selector)})')['result']
        self.call('DOM.setFileInputFiles', files=[str(path)], objectId=element['objectId'])

    def download(self, name, action):
        """The bytes of a file that the page saves."""
        path = self.folder / name
        path.unlink(missing_ok=True)
        action()
        end = time.monotonic() + PATIENCE
        while not path.exists():
            if time.monotonic() > end:
                raise SystemExit(f'{name} is not saved')
            time.sleep(0.02)
        return path.read_bytes()
