# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pages of the program as a browser shows them: Chromium without a screen, driven by its DevTools protocol."""

import base64
import fcntl
import io
import json
import os
import shutil
import subprocess
import sys
import time

from PIL import Image

OPTIONS = ('--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-first-run',
           '--disable-background-networking', '--disable-component-update', '--disable-sync', '--hide-scrollbars',
           '--remote-debugging-pipe')


class Browser:
    """A page of a browser, `width` by `height` pixels of the style sheet, each of which is drawn as two by two."""

    def __init__(self, folder, width, height):
        program = shutil.which('chromium')
        if program is None:
            sys.exit('figures.py: needs chromium for this figure')
        there, self.commands = os.pipe()
        self.answers, back = os.pipe()

        def connect():  # the browser reads from 3 and writes to 4, whatever the numbers are here
            copies = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (there, back)]
            for copy, number in zip(copies, (3, 4)):
                os.dup2(copy, number)

        self.process = subprocess.Popen([program, *OPTIONS, f'--user-data-dir={folder}/profile'], preexec_fn=connect,
                                        pass_fds=(3, 4), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(there)
        os.close(back)
        self.received, self.number, self.session = b'', 0, None
        target = self.call('Target.createTarget', url='about:blank')['targetId']
        self.session = self.call('Target.attachToTarget', targetId=target, flatten=True)['sessionId']
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=2, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.commands)
        self.process.terminate()
        self.process.wait()
        os.close(self.answers)

    def call(self, method, **parameters):
        """Sends a command, and returns what it gives; what the browser tells besides is dropped."""
        self.number += 1
        message = {'id': self.number, 'method': method, 'params': parameters}
        if self.session:
            message['sessionId'] = self.session
        os.write(self.commands, json.dumps(message).encode() + b'\0')
        while True:
            answer = json.loads(self.next_message())
            if answer.get('id') != self.number:
                continue
            if 'error' in answer:
                sys.exit(f'figures.py: {method}: {answer["error"]["message"]}')
            return answer['result']

    def next_message(self):
        while b'\0' not in self.received:
            piece = os.read(self.answers, 1 << 20)
            if not piece:
                sys.exit('figures.py: the browser has ended')
            self.received += piece
        message, _, self.received = self.received.partition(b'\0')
        return message

    def open(self, address):
        self.call('Page.navigate', url=address)

    def value(self, expression):
        return self.call('Runtime.evaluate', expression=expression, returnByValue=True)['result'].get('value')

    def wait(self, expression):
        """Until it is true on the page; gives up after two minutes."""
        for _ in range(1200):
            if self.value(f'Boolean({expression})'):
                return
            time.sleep(0.1)
        sys.exit(f'figures.py: the page does not come to {expression}')

    def click(self, x, y):
        for kind in ('mousePressed', 'mouseReleased'):
            self.call('Input.dispatchMouseEvent', type=kind, x=x, y=y, button='left', clickCount=1)

    def picture(self):
        """The page when it has nothing more to draw."""
        self.call('Runtime.evaluate', awaitPromise=True,
                  expression='new Promise((done) => setTimeout(() => requestAnimationFrame(done), 500))')
        data = self.call('Page.captureScreenshot', format='png')['data']
        return Image.open(io.BytesIO(base64.b64decode(data))).convert('RGB')
