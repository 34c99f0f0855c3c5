"""The faults themselves tested: what is drawn, and that a fault is made, judged and undone."""

import sys
import tempfile
import unittest
from pathlib import Path

from code import lines_of_code, masked
from fault import draw, faults_of, rooms, shares
from scratch import Scratch, Suite, copy_tree
from small_faults import once_survived, records
from trial import CAUGHT, SURVIVED, first_that_compiles, nearness

ROOT = Path(__file__).resolve().parent.parent.parent
COMPILER = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else "c++"


def made(rule, text):
    """The texts with each fault of a rule in them."""
    return {fault.put_into(text) for fault in faults_of("core/base/x.cpp", text) if fault.rule == rule}


class Masking(unittest.TestCase):
    def test_leaves_code_alone(self):
        text = ('#include <a> // 1 < 2\n#define X 1 < 2 \\\n  + 3\nassert(a < f(2));\n'
                'auto s = "1 < 2 \\" 3" + R"x(4 " < 5)x"; /* 6 < 7\n8 < 9 */ char c = \'"\'; int i = 1\'000;\n')
        code = masked(text)
        self.assertEqual(len(code), len(text))
        self.assertEqual(code.count("\n"), text.count("\n"))
        self.assertNotIn("<", code)
        self.assertIn("int i = 1'000;", code)
        self.assertEqual(lines_of_code("int a;\n\n// b\n  c();\n"), 2)


class Rules(unittest.TestCase):
    def test_make_their_faults(self):
        cases = [
            ("boundary", "if (a < b) c();", {"if (a <= b) c();"}),
            ("boundary", "template <typename T> std::vector<int> f(T&& a);", set()),
            ("reversal", "return a == b;", {"return a != b;"}),
            ("logic", "return a && b;", {"return a || b;"}),
            ("arithmetic", "x += a * b;", {"x -= a * b;", "x += a / b;"}),
            ("arithmetic", "const T* p = &a; *p = 1;", set()),
            ("sign", "return -x;", {"return x;"}),
            ("sign", "if (!found) f();", {"if (found) f();"}),
            ("constant", "f(2);", {"f(3);", "f(1);", "f((2 * 2));", "f((2 * 10));"}),
            ("constant", "std::array<int, 3> a1; std::get<0>(b);", set()),
            ("extremes", "std::min(a, b);", {"std::max(a, b);"}),
            ("truth", "f(true);", {"f(false);"}),
            ("guard", "if (!save(f)) return g;", {"if ((!save(f)) && false) return g;"}),
            ("dropped", "int a = f(b);\nv.push_back(a);\nreturn a;", {"int a = f(b);\n{}\nreturn a;"}),
            ("dropped", "for (;;) if (a) break;", {"for (;;) if (a) {}"}),
            ("dropped", "Type name(a);", set()),
            ("answer", "return f(a);", {"return {};"}),
        ]
        for rule, text, expected in cases:
            with self.subTest(rule=rule, text=text):
                self.assertEqual(made(rule, text), expected)


    def test_leave_looks_alone(self):
        text = "layout->setContentsMargins(2, 2, 2, 2);\nf(2);"
        self.assertEqual({fault.line for fault in faults_of("ui/panels/x.cpp", text)}, {2})
        self.assertEqual({fault.line for fault in faults_of("core/base/x.cpp", text)}, {1, 2})


class Draw(unittest.TestCase):
    def test_is_the_same_for_the_same_seed_and_spread_by_size(self):
        found = rooms(ROOT)
        self.assertGreater(len(found), 15)
        ids = [fault.id for _, faults in found.values() for fault in faults]
        self.assertEqual(len(ids), len(set(ids)))
        first, again, other = (draw(found, 60, seed) for seed in (1, 1, 2))
        self.assertEqual(len(first), 60)
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)
        in_room = sum(faults[0].room == "core/adjustment/joint" for faults in first)
        self.assertEqual(in_room, shares({room: lines for room, (lines, _) in found.items()}, 60)["core/adjustment/joint"])
        known = {faults[0].id for faults in first}
        self.assertTrue(known.isdisjoint(fault.id for faults in draw(found, 60, 1, known=known) for fault in faults))


TWICE = """int twice(int x) {
  return 2 * x;
}
int thrice(int x) {
  return 3 * x;
}
struct Plain {};
Plain plain() {
  return true ? Plain() : throw 1;
}
"""
MAIN = """#include <cstdio>
int twice(int x);
int main() {
  if (twice(3) == 6) return 0;
  std::puts("[  FAILED  ] Twice.Doubles");
  return 1;
}
"""


class OnceSurvived(unittest.TestCase):
    def test_stand_in_the_sources_still(self):
        self.assertEqual(len(list(once_survived())), len(records("once_survived.txt")))


class Trial(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        tree, self.place = Path(folder.name) / "tree", Path(folder.name) / "copy"
        (tree / "core" / "base").mkdir(parents=True)
        (tree / "core" / "base" / "twice.cpp").write_text(TWICE, encoding="utf-8")
        (tree / "main.cpp").write_text(MAIN, encoding="utf-8")
        copy_tree(tree, self.place)
        suite = Suite("core", "program", "program")
        suite.seconds = {"Twice.Doubles": 0.0}
        build = [COMPILER, "core/base/twice.cpp", "main.cpp", "-o"]
        self.scratch = Scratch(self.place, [suite], build, print)
        self.faults = faults_of("core/base/twice.cpp", TWICE)

    def tried(self, *places):
        """What becomes of the first that compiles of the faults on these lines, by rule."""
        return first_that_compiles([f for rule, line in places for f in self.faults if (f.rule, f.line) == (rule, line)],
                                   self.scratch)

    def test_makes_judges_and_undoes_a_fault(self):
        fault, outcome, by = self.tried(("arithmetic", 2))
        self.assertEqual((outcome, by), (CAUGHT, "Twice.Doubles"))
        self.assertEqual(fault.shown, "return 2 / x;")
        self.assertEqual(self.tried(("arithmetic", 5))[1], SURVIVED)
        fault, outcome, _ = self.tried(("truth", 9), ("answer", 2))
        self.assertEqual((fault.rule, outcome), ("truth", SURVIVED))
        self.assertEqual((self.place / "core/base/twice.cpp").read_text(encoding="utf-8"), TWICE)

    def test_takes_the_next_where_one_does_not_compile(self):
        broken = self.faults[0]._replace(new="no such thing", line=2)
        fault, outcome, _ = first_that_compiles([broken] + [f for f in self.faults if f.line == 2], self.scratch)
        self.assertEqual((fault.line, outcome), (2, CAUGHT))
        self.assertEqual((self.place / "core/base/twice.cpp").read_text(encoding="utf-8"), TWICE)
        self.assertIsNone(first_that_compiles([broken], self.scratch))

    def test_asks_the_nearest_first_however_often_they_are_instantiated(self):
        folder = self.place / "tests" / "core" / "base"
        folder.mkdir(parents=True)
        (folder / "twice_test.cpp").write_text("TEST_P(Doubled, Is) {}\nTYPED_TEST(Typed, Is) {}\n", encoding="utf-8")
        (folder / "other_test.cpp").write_text("TEST(Other, Is) {}\n", encoding="utf-8")
        near = nearness(self.faults[0], self.place)
        names = ["All/Doubled.Is/0", "Typed/1.Is", "Other.Is", "Elsewhere.Is"]
        self.assertEqual([near(name) for name in names], [0, 0, 1, 2])


if __name__ == "__main__":
    unittest.main()
