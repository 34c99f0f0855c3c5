#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alidade {

/// A family of lines of the self-test.
enum class CheckGroup { Fits, Published, Diagnosis, Distributions, Angles, Random, Installed, Window };

/// "fits", "published", …
const char* nameOf(CheckGroup group);

/// One line: what was expected from outside of the program, and what this installation found.
struct SelfCheck {
  enum class Outcome { Passed, Failed, LeftOut };

  CheckGroup group = CheckGroup::Fits;
  std::string name;  ///< of the line, with the unit of its numbers: "far, 0°: R (mm)"
  std::string expected = {}, found = {};
  /// |found − expected|/|expected|, and what it may be; absent of what is no number.
  std::optional<double> deviation = {}, tolerance = {};
  /// English, to be handed to `Phrase::of`: why it may be that, or how it was compared.
  const char* reason = "";
  Outcome outcome = Outcome::Failed;
};

/// What a number may deviate by, and why.
struct CheckTolerance {
  double absolute = 0;  ///< in the unit of the number
  double relative = 0;  ///< to the expected number; the larger of both holds
  const char* reason = "";
};

/// `expected` is a decimal text of any length, shown as it is; `found` counts as failed where it is no
/// number or `expected` is none.
SelfCheck numberCheck(CheckGroup group, std::string name, const std::string& expected, double found,
                      const CheckTolerance& tolerance);

/// Passes where both are the same text.
SelfCheck textCheck(CheckGroup group, std::string name, std::string expected, std::string found,
                    const char* reason);

/// The same of two hashes or other long texts, which are shown by how they begin.
SelfCheck hashCheck(CheckGroup group, std::string name, const std::string& expected, const std::string& found,
                    const char* reason);

/// Fails: the check could not be made, for the reason that stands as found.
SelfCheck brokenCheck(CheckGroup group, std::string name, std::string why);

}  // namespace alidade
