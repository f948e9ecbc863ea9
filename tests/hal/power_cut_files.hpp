// A folder in memory whose power goes at a chosen operation, with every state that a disk may then be found in.
//
// Granted after a power loss: the bytes of a file at its last sync_file(), the names at the last sync_folder(). Of
// later changes of names any subset may have reached the disk; of later bytes none, a part, all, or zeros of the full
// length.
#pragma once
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "hal/linux/store/file_operations.hpp"

namespace hal_test {

using Bytes = std::vector<uint8_t>;
using Disk = std::map<std::string, Bytes>;  // what a folder holds

class PowerCutFiles final : public hal::FileOperations {
 public:
  explicit PowerCutFiles(const Disk& disk) {
    for (const auto& [name, bytes] : disk) durable_names_[name] = names_[name] = add({bytes, bytes, true});
  }

  // The operation of this number (from 0) fails, done or half done, and so do all after it.
  void cut_at(int operation) { cut_at_ = operation; }
  int operations() const { return operation_; }
  bool cut() const { return cut_at_ >= 0 && operation_ > cut_at_; }

  bool create(const char* name) override {
    if (!powered()) return false;
    open_ = names_[name] = add({});
    changes_.push_back({"", name, open_});
    return !cut();
  }
  bool write(const uint8_t* bytes, size_t size) override {
    if (!powered()) return false;
    Bytes& content = files_[open_].bytes;
    content.insert(content.end(), bytes, bytes + size);
    files_[open_].synced = false;
    return !cut();
  }
  bool sync_file() override {
    if (!powered()) return false;
    if (cut()) return false;
    files_[open_].durable = files_[open_].bytes;
    files_[open_].synced = true;
    return true;
  }
  bool close() override { return !cut(); }
  bool rename(const char* from, const char* to) override {
    if (!powered()) return false;
    const auto found = names_.find(from);
    if (found == names_.end()) return false;
    const size_t file = found->second;
    names_.erase(found);
    names_[to] = file;
    changes_.push_back({from, to, file});
    return !cut();
  }
  bool sync_folder() override {
    if (!powered()) return false;
    if (cut()) return false;
    durable_names_ = names_;
    changes_.clear();
    return true;
  }
  size_t read(const char* name, uint8_t* bytes, size_t capacity) override {
    const auto found = names_.find(name);
    if (found == names_.end() || files_[found->second].bytes.size() > capacity) return 0;
    const Bytes& content = files_[found->second].bytes;
    std::memcpy(bytes, content.data(), content.size());
    return content.size();
  }

  // Every state that the disk may be found in if the power goes now.
  std::vector<Disk> after_power_loss() const {
    std::vector<Disk> result;
    for (unsigned subset = 0; subset < 1u << changes_.size(); ++subset) {
      auto names = durable_names_;
      for (size_t i = 0; i < changes_.size(); ++i) {
        if ((subset >> i & 1u) == 0) continue;
        if (!changes_[i].from.empty()) names.erase(changes_[i].from);
        names[changes_[i].to] = changes_[i].file;
      }
      add_contents(names, result);
    }
    return result;
  }
  Disk now() const {
    Disk disk;
    for (const auto& [name, file] : names_) disk[name] = files_[file].bytes;
    return disk;
  }

 private:
  struct File {
    Bytes bytes, durable;
    bool synced = false;
  };
  struct Change {
    std::string from, to;
    size_t file;
  };

  bool powered() {
    if (cut()) return false;
    ++operation_;
    return true;
  }
  size_t add(const File& file) {
    files_.push_back(file);
    return files_.size() - 1;
  }
  static std::vector<Bytes> possible(const File& file) {
    if (file.synced) return {file.durable};
    Bytes half = file.bytes, but_last = file.bytes;
    half.resize(file.bytes.size() / 2);
    if (!but_last.empty()) but_last.pop_back();
    return {file.durable, half, but_last, file.bytes, Bytes(file.bytes.size(), 0)};
  }
  void add_contents(const std::map<std::string, size_t>& names, std::vector<Disk>& result) const {
    std::vector<Disk> disks(1);
    for (const auto& [name, file] : names) {
      std::vector<Disk> next;
      for (const Bytes& bytes : possible(files_[file]))
        for (Disk disk : disks) {
          disk[name] = bytes;
          next.push_back(disk);
        }
      disks = next;
    }
    result.insert(result.end(), disks.begin(), disks.end());
  }

  std::vector<File> files_;
  std::map<std::string, size_t> names_, durable_names_;
  std::vector<Change> changes_;
  size_t open_ = 0;
  int operation_ = 0;
  int cut_at_ = -1;
};

}  // namespace hal_test
