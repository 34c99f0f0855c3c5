#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alidade {

/// A family of lines of the self-test.
enum class CheckGroup { Fits, Published, Diagnosis, Distributions, Angles, Random, Installed, Window };

/// "fits", "published", …
const char* nameOf(CheckGroup group);

/// One line: the externally known expected value, and the value from this installation.
struct SelfCheck {
  enum class Outcome { Passed, Failed, LeftOut };

  CheckGroup group = CheckGroup::Fits;
  std::string name;  ///< of the line, with the unit of its numbers: "far, 0°: R (mm)"
  std::string expected = {}, found = {};
  /// |found − expected|/|expected|, and its limit; absent for values that are not numbers.
  std::optional<double> deviation = {}, tolerance = {};
  /// English, for `Phrase::of`: the reason for the tolerance, or how the value was compared.
  const char* reason = "";
  Outcome outcome = Outcome::Failed;
};

/// The tolerance of a number, and its reason.
struct CheckTolerance {
  double absolute = 0;  ///< in the unit of the number
  double relative = 0;  ///< relative to the expected number; the larger of both applies
  const char* reason = "";
};

/// `expected` is a decimal text of any length, shown unchanged; the check fails if `found` is not finite or
/// `expected` is not a number.
SelfCheck numberCheck(CheckGroup group, std::string name, const std::string& expected, double found,
                      const CheckTolerance& tolerance);

/// Passes if both texts are equal.
SelfCheck textCheck(CheckGroup group, std::string name, std::string expected, std::string found,
                    const char* reason);

/// Compares two hashes or other long texts, of which only the beginning is shown.
SelfCheck hashCheck(CheckGroup group, std::string name, const std::string& expected, const std::string& found,
                    const char* reason);

/// Fails: the check could not be made, for the reason in `found`.
SelfCheck brokenCheck(CheckGroup group, std::string name, std::string why);

}  // namespace alidade
