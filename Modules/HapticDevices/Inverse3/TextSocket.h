#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace palpate
{
/// A WebSocket of text messages to this machine, of one io_context. One message is written at a
/// time; nothing waits behind it.
class TextSocket
{
public:
  /// Longest message that is read: a service tells of its devices in a few kilobytes.
  static constexpr std::size_t LongestMessage = 256 * 1024;

  struct Listener
  {
    std::function<void()> Connected;
    std::function<void(std::string_view)> Received;
    std::function<void()> Written;
    std::function<void(const std::string& reason)> Ended; ///< or never connected; once
  };

  TextSocket(boost::asio::io_context& context, Listener listener)
      : Stream(context), Heard(std::move(listener))
  {
  }

  void Connect(int port);
  /// While it writes nothing. Returns false otherwise.
  bool Write(std::string message);
  bool IsConnected() const noexcept { return this->HasConnected && !this->HasEnded; }
  void Close();

private:
  using Error = boost::system::error_code;

  void ReadNext();
  void End(const Error& error);

  boost::beast::websocket::stream<boost::beast::tcp_stream> Stream;
  Listener Heard;
  boost::beast::flat_buffer Buffer{LongestMessage};
  std::string Outgoing;
  bool IsWriting = false;
  bool HasConnected = false;
  bool HasEnded = false;
};
} // namespace palpate
