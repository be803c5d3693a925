"""Functions side by side, each with a folder of its own."""
import concurrent.futures
import pathlib
import queue
import shutil
import tempfile


class Workers:
    """Runs functions side by side, each with a folder of its own: two mutants may have the same test."""

    def __init__(self, count):
        self.root = tempfile.TemporaryDirectory(prefix="cm-")  # short, as messages and sockets hold paths
        self.free = queue.Queue()
        for number in range(count):
            self.free.put(pathlib.Path(self.root.name) / str(number))
        self.pool = concurrent.futures.ThreadPoolExecutor(count)

    def each(self, function, things):
        """The results of function(thing, folder), in the order of the things."""
        def in_a_folder(thing):
            folder = self.free.get()
            try:
                shutil.rmtree(folder, ignore_errors=True)
                folder.mkdir()
                return function(thing, folder)
            finally:
                self.free.put(folder)
        return self.pool.map(in_a_folder, things)
