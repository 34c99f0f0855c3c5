#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace alidade {

/// Takes a member of an object: its key, and a number, text or null.
using TakeMember = std::function<void(const char* key, const nlohmann::ordered_json& value)>;

/// A list of objects as long as the session, written member by member: a document that held all of them would
/// take many times their text.
struct LongList {
  std::string path;  ///< to an empty list of the document: `/two_faces/visits`
  std::size_t count = 0;
  std::function<void(std::size_t index, const TakeMember& take)> members;
};

/// A document as the console prints it: indented by two blanks, a newline at its end. What is no UTF-8 is
/// replaced, what is no number is null.
std::string jsonText(const nlohmann::ordered_json& document, const std::vector<LongList>& lists = {});

/// The document of an answer, with the program that gives it as its last member.
std::string answerText(nlohmann::ordered_json document, const std::vector<LongList>& lists = {});

}  // namespace alidade
