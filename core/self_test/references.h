#pragma once

#include <span>
#include <string>
#include <string_view>

namespace alidade {

// references.cmake compiles in these texts from tests/reference and samples.

/// A file by its name: a session, or a JSON document of independently calculated results.
struct ReferenceText {
  std::string_view name, text;
};
std::span<const ReferenceText> referenceTexts();

/// A file of the installation.
struct InstalledFile {
  std::string_view path;    ///< relative to the folder `share` of the prefix
  std::string_view sha256;  ///< hexadecimal
};
std::span<const InstalledFile> installedFiles();

/// The compiled-in text of this name; empty if there is none.
std::string_view referenceText(std::string_view name);

/// The reference values of the self-test, as JSON documents.
struct SelfTestReferences {
  std::string fits;     ///< results of tests/reference/high-precision/solve.py
  std::string numbers;  ///< of tests/reference/self-test/make_numbers.py
};
SelfTestReferences compiledReferences();

}  // namespace alidade
