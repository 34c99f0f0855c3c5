#include "core/self_test/references.h"

namespace alidade {

std::string_view referenceText(std::string_view name) {
  for (const ReferenceText& reference : referenceTexts())
    if (reference.name == name) return reference.text;
  return {};
}

SelfTestReferences compiledReferences() {
  return {std::string(referenceText("results.json")), std::string(referenceText("numbers.json"))};
}

}  // namespace alidade
