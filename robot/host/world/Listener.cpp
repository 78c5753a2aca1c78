// SPDX-License-Identifier: Apache-2.0
// How the two ends of a world socket find each other: listening, stale socket files, connecting to
// a world that is still starting.
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "robot/host/world/Connection.h"

namespace kelpie::host {
namespace {

constexpr int kRetryMs = 20;  // between two attempts to connect
constexpr int kBacklog = 16;  // two teams of four, and as many again

Error systemError(const std::string& path, const char* what) {
  return {path + ": " + what + ": " + std::strerror(errno)};
}

// Closes what it holds unless it was released.
struct Descriptor {
  explicit Descriptor(int opened = -1) : value(opened) {}
  ~Descriptor() {
    if (value >= 0) close(value);
  }
  Descriptor(Descriptor&& other) noexcept : value(other.release()) {}
  Descriptor& operator=(Descriptor&&) = delete;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int release() { return std::exchange(value, -1); }
  int value;
};

struct Address {
  sockaddr_un place{};
  Descriptor folder;  // through which a long path is reached
};

// The system takes 107 characters; a folder of temporary files may have more. Such a folder is
// opened, and what lies in it is reached by its number.
Expected<std::string> shortened(const std::string& path, Descriptor& folder) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return path;
  const std::string above = path.substr(0, slash + 1);
  Descriptor opened(open(above.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (opened.value < 0) return systemError(path, "its folder cannot be opened");
  folder.value = opened.release();
  return "/proc/self/fd/" + std::to_string(folder.value) + path.substr(slash);
}

Expected<Address> addressOf(const std::string& path) {
  Address address;
  address.place.sun_family = AF_UNIX;
  constexpr std::size_t kMax = sizeof address.place.sun_path - 1;
  const Expected<std::string> taken =
      path.size() > kMax ? shortened(path, address.folder) : Expected<std::string>(path);
  if (!taken) return Error{taken.error()};
  if (taken->empty() || taken->size() > kMax) {
    return Error{"socket path '" + path + "' has " + std::to_string(path.size()) +
                 " characters; its name may have 1 to 80"};
  }
  std::memcpy(address.place.sun_path, taken->c_str(), taken->size() + 1);
  return Expected<Address>(std::move(address));
}

int newSocket() { return socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0); }

bool reaches(int descriptor, const sockaddr_un& address) {
  return ::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

// Frees the path when nobody serves it any more.
Status clearPath(const std::string& path, const sockaddr_un& address) {
  struct stat info {};
  if (lstat(path.c_str(), &info) != 0) return Done{};
  if (!S_ISSOCK(info.st_mode)) return Error{path + ": exists and is not a socket"};
  const Descriptor probe(newSocket());
  if (reaches(probe.value, address)) return Error{path + ": another world listens here"};
  if (errno != ECONNREFUSED) return systemError(path, "cannot tell whether it is in use");
  if (unlink(path.c_str()) != 0) return systemError(path, "cannot remove the stale socket");
  return Done{};
}

}  // namespace

Expected<Connection> Connection::connect(const std::string& path, const ConnectionParams& params) {
  const Expected<Address> address = addressOf(path);
  if (!address) return Error{address.error()};
  const int attempts = 1 + static_cast<int>(params.connectTimeout * 1000.0 / kRetryMs);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (attempt > 0) poll(nullptr, 0, kRetryMs);
    Descriptor descriptor(newSocket());
    if (descriptor.value < 0) return systemError(path, "no socket");
    if (reaches(descriptor.value, address->place)) return Connection(descriptor.release(), params);
    if (errno != ENOENT && errno != ECONNREFUSED && errno != EINTR) break;
  }
  return systemError(path, "cannot connect");
}

Expected<ConnectionPair> connectedPair(const ConnectionParams& params) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    return systemError("socket pair", "cannot create");
  }
  return ConnectionPair{Connection(ends[0], params), Connection(ends[1], params)};
}

Expected<Listener> Listener::open(const std::string& path) {
  const Expected<Address> address = addressOf(path);
  if (!address) return Error{address.error()};
  const Status cleared = clearPath(path, address->place);
  if (!cleared) return Error{cleared.error()};
  Descriptor descriptor(newSocket());
  if (descriptor.value < 0) return systemError(path, "no socket");
  const auto* bound = reinterpret_cast<const sockaddr*>(&address->place);
  if (bind(descriptor.value, bound, sizeof address->place) != 0)
    return systemError(path, "cannot bind");
  if (listen(descriptor.value, kBacklog) != 0) return systemError(path, "cannot listen");
  return Listener(descriptor.release(), path);
}

Listener::Listener(int descriptor, std::string path)
    : descriptor_(descriptor), path_(std::move(path)) {}

Listener::~Listener() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  unlink(path_.c_str());
}

Listener::Listener(Listener&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

Listener& Listener::operator=(Listener&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  return *this;
}

bool Listener::isCalled(double seconds) const {
  pollfd waiting{descriptor_, POLLIN, 0};
  return poll(&waiting, 1, static_cast<int>(seconds * 1000.0)) > 0;
}

Expected<Connection> Listener::accept(double seconds, const ConnectionParams& params) {
  pollfd waiting{descriptor_, POLLIN, 0};
  const int ready = poll(&waiting, 1, static_cast<int>(seconds * 1000.0));
  if (ready == 0) return Error{path_ + ": nobody connected in " + std::to_string(seconds) + " s"};
  if (ready < 0) return systemError(path_, "cannot wait");
  const int descriptor = accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC);
  if (descriptor < 0) return systemError(path_, "cannot accept");
  return Connection(descriptor, params);
}

}  // namespace kelpie::host
