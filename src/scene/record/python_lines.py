# Marks the calls of PyOpenGL with the lines of the program that make them. Python imports this as sitecustomize at its start.
#
# A mark is glStringMarkerGREMEDY with the call stack, as apitrace prints that of a program in C:
#     python: display: /home/me/lamp.py:12
import ctypes
import importlib.machinery
import os
import sys

_MODULES = ("OpenGL.GL", "OpenGL.GLU", "OpenGL.GLUT")
_FOLDER = os.path.dirname(os.path.abspath(__file__))
_last = None
try:
    _send = ctypes.CDLL(None).glStringMarkerGREMEDY
    _send.argtypes = [ctypes.c_int, ctypes.c_char_p]
    _send.restype = None
except AttributeError:  # apitrace is not loaded
    _send = None


def _is_own(file):
    return not (file.startswith(("<", sys.base_prefix + os.sep + "lib")) or "-packages" + os.sep in file
                or os.path.dirname(file) == _FOLDER)


def _mark(frame):
    global _last
    frames = []
    while frame:
        code = frame.f_code
        if _is_own(code.co_filename):
            name = "main" if code.co_name == "<module>" else code.co_name
            frames.append("python: %s: %s:%d\n" % (name, os.path.abspath(code.co_filename), frame.f_lineno))
        frame = frame.f_back
    text = "".join(frames).encode("utf-8", "replace")
    if text != _last:
        _last = text
        _send(len(text), text)


class _Marked:
    """A function of PyOpenGL that sends a mark first."""

    def __init__(self, function):
        self.__dict__["_function"] = function

    def __call__(self, *arguments, **named):
        _mark(sys._getframe(1))
        return self._function(*arguments, **named)

    def __bool__(self):
        return bool(self._function)

    def __getattr__(self, name):
        return getattr(self._function, name)

    def __setattr__(self, name, value):
        setattr(self._function, name, value)


class _Finder:
    """Finds the modules of PyOpenGL as usual, and marks their functions once they are loaded."""

    @staticmethod
    def find_spec(name, path, target=None):
        if name not in _MODULES:
            return None
        spec = importlib.machinery.PathFinder.find_spec(name, path, target)
        if spec and spec.loader:
            load = spec.loader.exec_module

            def exec_module(module):
                load(module)
                for key, value in list(vars(module).items()):
                    if key.startswith("gl") and callable(value) and not isinstance(value, (type, _Marked)):
                        setattr(module, key, _Marked(value))

            spec.loader.exec_module = exec_module
        return spec


if _send:
    sys.meta_path.insert(0, _Finder)

# The sitecustomize of this system, if it has one.
sys.path[:] = [folder for folder in sys.path if os.path.abspath(folder) != _FOLDER]
_own = sys.modules.pop("sitecustomize", None)
try:
    import sitecustomize  # noqa: F401
except ImportError:
    sys.modules["sitecustomize"] = _own
