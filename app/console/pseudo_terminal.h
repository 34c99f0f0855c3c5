#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade::console {

/// A pseudo terminal in place of an instrument's port: bytes written here are read from `path()`, and vice
/// versa. The line is raw. The end at `path()` stays open, so that a reader can disconnect and reconnect.
class PseudoTerminal {
 public:
  static Result<PseudoTerminal> open();
  PseudoTerminal(PseudoTerminal&& other) noexcept;
  PseudoTerminal& operator=(PseudoTerminal&&) = delete;
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal();

  const std::string& path() const { return m_path; }  ///< "/dev/pts/3"
  int descriptor() const { return m_master; }
  /// The available bytes, without waiting.
  std::string read() const;
  /// Returns false if the buffer is full because nobody reads. Bytes that do not fit are lost, as on a wire.
  bool write(std::string_view bytes) const;

 private:
  PseudoTerminal(int master, int slave, std::string path)
      : m_master(master), m_slave(slave), m_path(std::move(path)) {}

  int m_master, m_slave;
  std::string m_path;
};

}  // namespace alidade::console
