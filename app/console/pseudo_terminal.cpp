#include "app/console/pseudo_terminal.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace alidade::console {

namespace {

Problem failed(const char* step) {
  return Problem{std::string("a pseudo-terminal could not be made: ") + step + ": " + std::strerror(errno)};
}

}  // namespace

Result<PseudoTerminal> PseudoTerminal::open() {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master < 0) return failed("opening");
  std::array<char, 128> name{};
  if (grantpt(master) != 0 || unlockpt(master) != 0 || ptsname_r(master, name.data(), name.size()) != 0) {
    const Problem problem = failed("unlocking");
    ::close(master);
    return problem;
  }
  const int slave = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  if (slave < 0 || tcgetattr(slave, &settings) != 0) {
    const Problem problem = failed(name.data());
    ::close(master);
    if (slave >= 0) ::close(slave);
    return problem;
  }
  cfmakeraw(&settings);
  tcsetattr(slave, TCSANOW, &settings);
  return PseudoTerminal(master, slave, name.data());
}

PseudoTerminal::PseudoTerminal(PseudoTerminal&& other) noexcept
    : m_master(std::exchange(other.m_master, -1)),
      m_slave(std::exchange(other.m_slave, -1)),
      m_path(std::move(other.m_path)) {}

PseudoTerminal::~PseudoTerminal() {
  for (const int end : {m_master, m_slave})
    if (end >= 0) ::close(end);
}

std::string PseudoTerminal::read() const {
  std::string bytes;
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t count = ::read(m_master, part.data(), part.size());
    if (count <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
}

bool PseudoTerminal::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::write(m_master, bytes.data(), bytes.size());
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace alidade::console
