#include "ui/report/pdf_attachments.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <stdexcept>
#include <utility>

#include "core/exchange/words.h"

namespace alidade::ui {

namespace {

using Outcome = AttachedFile::Outcome;

/// Writes everything to a pipe, despite interruptions.
bool writeAll(int pipe, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(pipe, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

/// Writes the contents of a stream to a pipe, up to a limit.
class Handing : public Pipeline {
 public:
  Handing(int pipe, std::size_t most) : Pipeline("attached", nullptr), m_pipe(pipe), m_left(most) {}

  void write(const unsigned char* data, std::size_t length) override {
    m_isTooMuch = m_isTooMuch || length > m_left;
    if (m_isTooMuch) throw std::length_error("too much");
    m_left -= length;
    if (!writeAll(m_pipe, reinterpret_cast<const char*>(data), length))
      throw std::runtime_error("nobody reads it");
  }
  void finish() override {}

  bool isTooMuch() const { return m_isTooMuch; }

 private:
  int m_pipe;
  std::size_t m_left;
  bool m_isTooMuch = false;
};

Outcome handContent(QPDFObjectHandle stream, int pipe, std::size_t mostBytes) {
  if (!stream.isStream()) return Outcome::Missing;
  Handing handing(pipe, mostBytes);
  const bool isWhole = stream.pipeStreamData(&handing, nullptr, 0, qpdf_dl_generalized, true);
  if (handing.isTooMuch()) return Outcome::TooLarge;
  return isWhole ? Outcome::Found : Outcome::Damaged;
}

bool endsWith(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         lowerCase(std::string(name.substr(name.size() - ending.size()))) == lowerCase(std::string(ending));
}

/// Writes the attached file's contents to the pipe, or the reason if the document is unreadable.
Outcome handFile(std::string_view pdf, std::string_view ending, int pipe, std::size_t mostBytes) {
  try {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("report", pdf.data(), pdf.size());
    QPDFEmbeddedFileDocumentHelper files(document);
    for (const auto& [name, file] : files.getEmbeddedFiles())
      if (endsWith(file->getFilename(), ending))
        return handContent(file->getEmbeddedFileStream(), pipe, mostBytes);
    return Outcome::NotThere;
  } catch (const std::bad_alloc&) {
    return Outcome::Exhausting;
  } catch (const std::exception& failure) {
    writeAll(pipe, failure.what(), std::strlen(failure.what()));
    return Outcome::Unreadable;
  }
}

constexpr int firstCode = 32;  // exit code of the first outcome, above the usual exit codes

int codeOf(Outcome outcome) {
  return firstCode + static_cast<int>(outcome);
}

[[noreturn]] void giveUp() {
  _exit(codeOf(Outcome::Exhausting));
}

/// Address space taken by the program, in bytes; absent if the system does not report it.
std::optional<std::size_t> addressesTaken() {
  std::size_t pages = 0;
  if (!(std::ifstream("/proc/self/statm") >> pages)) return std::nullopt;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void lower(__rlimit_resource resource, std::size_t most) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(limit.rlim_max, most);
  setrlimit(resource, &limit);
}

/// Limits the reading process; `taken`: `addressesTaken` before the fork. qpdf mistakes lack of memory for a
/// damaged document, so the first failed allocation ends the process.
void bound(std::optional<std::size_t> taken, std::size_t mostMemory) {
  constexpr std::size_t seconds = 60;
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTERM, SIGINT})
    std::signal(fault, SIG_DFL);
  std::signal(SIGPIPE, SIG_IGN);
  lower(RLIMIT_CORE, 0);
  lower(RLIMIT_CPU, seconds);
  if (taken) lower(RLIMIT_AS, *taken + mostMemory);
  std::set_new_handler(giveUp);
}

/// Reads all that the other process sends. False if reading fails or nothing arrives in time.
bool takeAll(int pipe, std::string& bytes) {
  constexpr int longest = 120'000;  // ms
  std::array<char, std::size_t{1} << 16> chunk{};
  for (;;) {
    pollfd waiting{pipe, POLLIN, 0};
    const int ready = poll(&waiting, 1, longest);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t size = read(pipe, chunk.data(), chunk.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return size == 0;
    bytes.append(chunk.data(), static_cast<std::size_t>(size));
  }
}

/// A process that reads a document, and its output.
class Reader {
 public:
  Reader(pid_t process, int pipe) : m_process(process), m_pipe(pipe) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() {
    close(m_pipe);
    if (m_process <= 0) return;
    kill(m_process, SIGKILL);
    end();
  }

  AttachedFile result() {
    std::string bytes;
    if (!takeAll(m_pipe, bytes)) return {Outcome::Exhausting};
    const int status = end();
    if (WIFSIGNALED(status)) {
      const int by = WTERMSIG(status);
      if (by == SIGXCPU || by == SIGKILL) return {Outcome::Exhausting};
      return {Outcome::Unreadable, {}, strsignal(by)};
    }
    const auto outcome = static_cast<Outcome>(WEXITSTATUS(status) - firstCode);
    if (outcome == Outcome::Found) return {outcome, std::move(bytes)};
    if (outcome < Outcome::Found || outcome >= Outcome::Unreadable)
      return {Outcome::Unreadable, {}, std::move(bytes)};
    return {outcome};
  }

 private:
  pid_t m_process;
  int m_pipe;

  /// Waits for the end of the process and returns its status.
  int end() {
    const pid_t process = std::exchange(m_process, 0);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    return status;
  }
};

}  // namespace

AttachedFile attachedFile(std::string_view pdf, std::string_view ending, const PdfLimits& limits) {
  const std::optional<std::size_t> taken = addressesTaken();
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return {Outcome::Unreadable, {}, std::strerror(errno)};
  const pid_t process = fork();
  if (process == 0) {
    bound(taken, limits.mostMemory);
    _exit(codeOf(handFile(pdf, ending, ends[1], limits.mostBytes)));
  }
  const int why = errno;
  close(ends[1]);
  Reader reader(process, ends[0]);
  if (process < 0) return {Outcome::Unreadable, {}, std::strerror(why)};
  return reader.result();
}

}  // namespace alidade::ui
