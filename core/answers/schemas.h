#pragma once

#include <span>
#include <string_view>

namespace alidade {

/// The structure of a document that other programs may rely on, as JSON Schema (draft 2020-12). The texts are
/// the files of `schemas/`, compiled in.
struct AnswerSchema {
  std::string_view name;  ///< "fit": of `alidade-cli fit --json`; "session": of the session file
  std::string_view text;
};

std::span<const AnswerSchema> answerSchemas();

}  // namespace alidade
