"""The hints of types (_kernels.pyi) have the names and parameters of the compiled module."""

import ast
import inspect
import pathlib
import re
import unittest

import palpate
from palpate import _kernels


def parameters_of_stub(function):
    """(name, default) of each, without self."""
    given = function.args
    positional = given.posonlyargs + given.args
    defaults = [None] * (len(positional) - len(given.defaults)) + [ast.unparse(d) for d in given.defaults]
    pairs = list(zip([a.arg for a in positional], defaults))
    pairs += [(a.arg, d and ast.unparse(d)) for a, d in zip(given.kwonlyargs, given.kw_defaults)]
    return [pair for pair in pairs if pair[0] != "self"]


def parameters_of_binding(function):
    """The same, from the signature that pybind11 writes into the docstring."""
    overloads = re.findall(r"^(?:\d+\. )?\w+\((.*)\) -> ", function.__doc__, re.MULTILINE)
    pairs = re.findall(r"(\w+): [\w.\[\]:, |]+?(?: = ([^,)]+))?(?=, \w+:|, \*|$)", overloads[-1])
    return [(name, default or None) for name, default in pairs if name != "self"]


class Stub(unittest.TestCase):
    def setUp(self):
        source = pathlib.Path(palpate.__file__).with_name("_kernels.pyi").read_text()
        self.names = {node.name: node for node in ast.parse(source).body if hasattr(node, "name")}

    def compare(self, stub, binding):
        with self.subTest(stub.name):
            self.assertEqual(parameters_of_stub(stub), parameters_of_binding(binding))

    def test_names_are_those_of_the_module(self):
        public = {name for name in vars(_kernels) if not name.startswith("_")}
        self.assertEqual(public, {*self.names, "contact_dtype"})

    def test_members_are_those_of_the_classes(self):
        for name, stub in self.names.items():
            if not isinstance(stub, ast.ClassDef) or name == "Error":
                continue
            bound = vars(_kernels)[name]
            members = {node.name: node for node in stub.body}
            public = {n for n in vars(bound) if not n.startswith("_")}
            self.assertEqual(public, {n for n in members if not n.startswith("_")}, name)
            for member, node in members.items():
                if inspect.isroutine(getattr(bound, member)) and member != "__exit__":
                    self.compare(node, getattr(bound, member))

    def test_functions_have_the_same_parameters(self):
        for name, stub in self.names.items():
            if isinstance(stub, ast.FunctionDef):
                self.compare(stub, vars(_kernels)[name])

    def test_everything_has_a_docstring(self):
        for name in self.names:
            bound = vars(_kernels)[name]
            members = [m for n, m in vars(bound).items() if not n.startswith("_")] if inspect.isclass(bound) else []
            for documented in [bound, *members]:
                text = re.sub(r"^(\d+\. )?\w+\(.*\) -> .*$|^Overloaded function\.$", "", documented.__doc__, flags=re.M)
                self.assertTrue(text.strip(), f"{name}: {documented}")


if __name__ == "__main__":
    unittest.main()
