#include "core/connection/line_assembler.h"

#include <algorithm>
#include <array>

#include "core/base/phrase.h"

namespace alidade {

namespace {

constexpr std::size_t shownOfLine = 60;

bool endsLine(char c) {
  return c == '\r' || c == '\n';
}

std::string shownShort(const std::string& line) {
  return shownLine(line.substr(0, shownOfLine)) + (line.size() > shownOfLine ? "…" : "");
}

}  // namespace

void LineAssembler::take(std::string_view bytes, Milliseconds now, std::vector<std::string>& lines,
                         std::vector<std::string>& remarks) {
  if (bytes.empty()) return;
  tick(now, remarks);
  m_last = now;
  while (!bytes.empty()) {
    const auto* const end = std::find_if(bytes.begin(), bytes.end(), endsLine);
    const auto length = static_cast<std::size_t>(end - bytes.begin());
    if (!m_isTooLong && m_line.size() + length > longest) {
      m_line.append(bytes.substr(0, std::min(length, longest)));
      remarks.push_back(
          Phrase::of("More than %1 characters came without an end of line; they were dropped (%2). Do baud "
                     "rate, data bits and parity match the instrument?",
                     longest, shownShort(m_line)));
      m_isTooLong = true;
      m_line.clear();
    }
    if (!m_isTooLong) m_line.append(bytes.substr(0, length));
    if (length == bytes.size()) return;
    if (!m_isTooLong && !m_line.empty()) lines.push_back(std::move(m_line));
    m_line.clear();
    m_isTooLong = false;
    bytes.remove_prefix(length + 1);
  }
}

void LineAssembler::tick(Milliseconds now, std::vector<std::string>& remarks) {
  const auto due = wakeAt();
  if (!due || now < *due) return;
  if (!m_isTooLong)
    remarks.push_back(Phrase::of("Only part of a line came; it was dropped (%1). Is the cable plugged in?",
                                 shownShort(m_line)));
  m_line.clear();
  m_isTooLong = false;
}

std::optional<Milliseconds> LineAssembler::wakeAt() const {
  if (m_line.empty() && !m_isTooLong) return std::nullopt;
  return m_last + m_lineWithin;
}

std::string shownLine(std::string_view line) {
  constexpr std::array<const char*, 16> digits = {"0", "1", "2", "3", "4", "5", "6", "7",
                                                  "8", "9", "A", "B", "C", "D", "E", "F"};
  std::string shown;
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      shown += c;
    } else if (c == '\r') {
      shown += "<CR>";
    } else if (c == '\n') {
      shown += "<LF>";
    } else {
      shown += std::string("<") + digits.at(byte / 16U) + digits.at(byte % 16U) + ">";
    }
  }
  return shown;
}

}  // namespace alidade
