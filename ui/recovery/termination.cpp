#include "ui/recovery/termination.h"

#include <fcntl.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <csignal>
#include <cstdlib>

namespace alidade::ui {

namespace {

constexpr int terminations[] = {SIGTERM, SIGINT, SIGHUP};

/// Connects the signal handler with the event loop; −1: closed.
int terminationPipe[2] = {-1, -1};

void passOn(int signal) {
  const auto number = static_cast<unsigned char>(signal);
  [[maybe_unused]] const ssize_t written = write(terminationPipe[1], &number, 1);
}

void setHandler(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {}, before = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
}

}  // namespace

Termination::Termination(QObject* parent) : QObject(parent) {
  Q_ASSERT(terminationPipe[0] < 0);
  if (pipe2(terminationPipe, O_CLOEXEC | O_NONBLOCK) != 0) return;
  auto* notifier = new QSocketNotifier(terminationPipe[0], QSocketNotifier::Read, this);
  connect(notifier, &QSocketNotifier::activated, this, &Termination::take);
  constexpr int onceOnly = static_cast<int>(SA_RESETHAND);
  for (const int signal : terminations) setHandler(signal, passOn, SA_RESTART | onceOnly);
}

Termination::~Termination() {
  for (const int signal : terminations) setHandler(signal, SIG_DFL, 0);
  for (int& end : terminationPipe) {
    if (end >= 0) close(end);
    end = -1;
  }
}

void Termination::take() {
  unsigned char number = 0;
  if (read(terminationPipe[0], &number, 1) != 1) return;
  if (m_signal == 0) m_signal = number;
  emit requested();
}

void endBySignal(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::_Exit(128 + signal);
}

}  // namespace alidade::ui
