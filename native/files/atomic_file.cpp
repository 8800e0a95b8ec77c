// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace hull::files {

namespace fs = std::filesystem;

// A new file that is removed again unless it is renamed to its final name.
class ReplacingFile::NewFile {
 public:
  explicit NewFile(const fs::path& target) {
    // Nobody else has this name: the process and a running number make it.
    static std::atomic<unsigned> number{0};
    do {
      // Of its own length: the final name may be as long as names can be.
      const std::string own = std::to_string(getpid()) + "." + std::to_string(number++) + ".part";
      // Beside the target: a rename is only atomic within one file system.
      name_ = (target.parent_path() / (".hull-" + own)).string();
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) fail();
  }
  ~NewFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!name_.empty()) unlink(name_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write_all(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      bytes.remove_prefix(static_cast<size_t>(count));
    }
  }

  void rename_to(const fs::path& target) {
    struct stat old {};
    // The new file takes the rights of the old one; where it can't, those of a new file serve.
    if (stat(target.c_str(), &old) == 0) fchmod(descriptor_, old.st_mode & 07777);
    // Before the rename: else a crash might leave the new name with bytes that never reached the
    // disk.
    if (fsync(descriptor_) != 0 && errno != EINVAL) fail();  // EINVAL: a place that has no disk
    const int descriptor = descriptor_;
    descriptor_ = -1;
    // Some file systems, as those of networks, tell only here that the disk was full.
    if (close(descriptor) != 0) fail();
    if (std::rename(name_.c_str(), target.c_str()) != 0) fail();
    name_.clear();
  }

  const std::string& name() const { return name_; }

 private:
  [[noreturn]] static void fail() {
    throw fs::filesystem_error("", std::error_code(errno, std::generic_category()));
  }

  std::string name_;
  int descriptor_ = -1;
};

namespace {

constexpr int kMostLinks = 40;  // as the kernel follows

// Where a chain of symbolic links ends, whether or not there is anything.
// By hand, as std::filesystem::canonical() wants the last file to be there.
fs::path end_of_links(fs::path path) {
  for (int link = 0; fs::is_symlink(path); ++link) {
    if (link == kMostLinks) {
      throw fs::filesystem_error("",
                                 std::make_error_code(std::errc::too_many_symbolic_link_levels));
    }
    // A relative link counts from its own folder; an absolute one replaces all before it.
    path = path.parent_path() / fs::read_symlink(path);
  }
  return path;
}

bool is_control(unsigned char letter) { return letter < 0x20 || letter == 0x7f; }

// Why, and what to do about it.
std::string reason_of(const std::error_code& code) {
  if (code == std::errc::filename_too_long) return "the name is too long; shorten it";
  std::string reason = code.message();
  if (code == std::errc::no_space_on_device || code == std::errc::file_too_large ||
      code.value() == EDQUOT) {
    reason += "; free some space, or choose another folder";
  } else if (code == std::errc::permission_denied || code == std::errc::read_only_file_system) {
    reason += "; choose a folder that you may write to";
  }
  return reason;
}

template <class Do>
void or_file_error(const std::string& path, const Do& action) {
  try {
    action();
  } catch (const fs::filesystem_error& error) {
    throw FileError("Cannot write \"" + path + "\": " + reason_of(error.code()));
  } catch (const std::runtime_error& error) {
    throw FileError("Cannot write \"" + path + "\": " + error.what());
  }
}

}  // namespace

ReplacingFile::ReplacingFile(const std::string& path) : path_(path) {
  or_file_error(path_, [&] {
    fs::path target = path;
    const std::string own_name = target.filename().string();
    if (std::any_of(own_name.begin(), own_name.end(), is_control)) {
      throw std::runtime_error(
          "a file's name can't have line breaks or control characters; give it another");
    }
    target = end_of_links(target);
    // Without a folder the name is in the present one.
    const fs::path folder = target.parent_path();
    if (!folder.empty() && !fs::is_directory(folder)) {
      throw std::runtime_error("there is no folder \"" + folder.string() + "\"; make it first");
    }
    if (!target.has_filename() || fs::is_directory(target)) {
      throw std::runtime_error("it is a folder; give a file name");
    }
    // To rename a file to a device's name would take the device away.
    if (fs::exists(target) && !fs::is_regular_file(target)) {
      throw std::runtime_error("it is a device or pipe and no file; give another name");
    }
    target_ = target.string();
    file_ = std::make_unique<NewFile>(target);
  });
}

ReplacingFile::~ReplacingFile() = default;

const std::string& ReplacingFile::name() const { return file_->name(); }

void ReplacingFile::write(std::string_view bytes) {
  or_file_error(path_, [&] { file_->write_all(bytes); });
}

void ReplacingFile::replace() {
  or_file_error(path_, [&] { file_->rename_to(target_); });
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  ReplacingFile file(path);
  file.write(bytes);
  file.replace();
}

}  // namespace hull::files
