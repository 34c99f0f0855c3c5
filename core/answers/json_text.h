#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace alidade {

/// Receives a member of an object: its key, and a number, text or null.
using TakeMember = std::function<void(const char* key, const nlohmann::ordered_json& value)>;

/// A list of objects as long as the session, written member by member. A document that contained all objects
/// would take many times the memory of their text.
struct LongList {
  std::string path;  ///< path of an empty list in the document: `/two_faces/visits`
  std::size_t count = 0;
  std::function<void(std::size_t index, const TakeMember& take)> members;
};

/// Returns a document as the console prints it: indented by two blanks, with a newline at its end. Bytes that
/// are not UTF-8 are replaced; numbers that are not finite become null.
std::string jsonText(const nlohmann::ordered_json& document, const std::vector<LongList>& lists = {});

/// The document of an answer, with the program that gives it as its last member.
std::string answerText(nlohmann::ordered_json document, const std::vector<LongList>& lists = {});

}  // namespace alidade
