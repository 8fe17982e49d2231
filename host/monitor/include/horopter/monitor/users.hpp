// SPDX-License-Identifier: Apache-2.0
// Who may do what on the page: a file of names, roles and hashes of passwords.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace horopter::monitor {

/// Each may also do what those before it may.
enum class Role {
  viewer,          ///< look
  plant_operator,  ///< restart, where the configuration allows it
  engineer,        ///< teach
};
std::string_view name_of(Role role);
std::optional<Role> role_named(std::string_view name);

struct User {
  std::string name;
  Role role = Role::viewer;
  std::string hash;  ///< Argon2id, as libsodium writes it
};

inline constexpr std::size_t kShortestPassword = 8;
inline constexpr std::size_t kLongestPassword = 256;

/// A line for each: `NAME ROLE HASH`; lines that begin with # are comments. Throws FileError: also where others than the
/// owner and the group may read it, or others than the owner may write to it.
std::vector<User> read_users(const std::filesystem::path& file);
/// Adds a user, or gives a new role and password; makes the file, for its owner alone, where there is none, and keeps
/// owner, group and mode of one that is there. Like remove_user it waits for others that change the file. Throws
/// UsageError for a name or a password that cannot be, FileError for the file.
void set_user(const std::filesystem::path& file, const std::string& name, Role role, const std::string& password);
/// False where there was none of this name.
bool remove_user(const std::filesystem::path& file, const std::string& name);

/// Takes as long for a name that there is not. Some 0.1 s and 64 MB.
bool is_password(const User* user, const std::string& password);

}  // namespace horopter::monitor
