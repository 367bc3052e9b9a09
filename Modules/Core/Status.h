#pragma once

#include <string>
#include <utility>

namespace palpate
{
/// Result of a kernel that can refuse its input: success, or a one-sentence error message.
/// Level 0 does not throw; callers turn the message into their own kind of error.
class [[nodiscard]] Status
{
public:
  static Status Success() { return {}; }
  static Status Failure(std::string message) { return Status(std::move(message)); }

  bool IsOk() const noexcept { return this->Ok; }
  const std::string& Message() const noexcept { return this->Text; }

private:
  Status() = default;
  explicit Status(std::string message) : Ok(false), Text(std::move(message)) {}

  bool Ok = true;
  std::string Text;
};
} // namespace palpate
