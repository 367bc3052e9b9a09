#include "TextSocket.h"

#include <boost/asio/buffer.hpp>

#include <utility>

namespace palpate
{
namespace beast = boost::beast;

void TextSocket::Connect(int port)
{
  const boost::asio::ip::tcp::endpoint here(boost::asio::ip::address_v4::loopback(),
                                            static_cast<unsigned short>(port));
  this->Stream.read_message_max(LongestMessage);
  this->Stream.text(true);
  beast::get_lowest_layer(this->Stream)
      .async_connect(here,
                     [this, port](const Error& error)
                     {
                       if (error)
                       {
                         this->End(error);
                         return;
                       }
                       Error ignored;
                       beast::get_lowest_layer(this->Stream)
                           .socket()
                           .set_option(boost::asio::ip::tcp::no_delay(true), ignored);
                       this->Stream.async_handshake("localhost:" + std::to_string(port), "/",
                                                    [this](const Error& failed)
                                                    {
                                                      if (failed)
                                                      {
                                                        this->End(failed);
                                                        return;
                                                      }
                                                      this->HasConnected = true;
                                                      this->Heard.Connected();
                                                      this->ReadNext();
                                                    });
                     });
}

void TextSocket::ReadNext()
{
  this->Stream.async_read(
      this->Buffer,
      [this](const Error& error, std::size_t)
      {
        if (error)
        {
          this->End(error);
          return;
        }
        const auto bytes = this->Buffer.cdata();
        this->Heard.Received({static_cast<const char*>(bytes.data()), bytes.size()});
        this->Buffer.consume(this->Buffer.size());
        if (!this->HasEnded)
        {
          this->ReadNext();
        }
      });
}

bool TextSocket::Write(std::string message)
{
  if (this->IsWriting || !this->IsConnected())
  {
    return false;
  }
  this->IsWriting = true;
  this->Outgoing = std::move(message);
  this->Stream.async_write(boost::asio::buffer(this->Outgoing),
                           [this](const Error& error, std::size_t)
                           {
                             this->IsWriting = false;
                             if (error)
                             {
                               this->End(error);
                               return;
                             }
                             this->Heard.Written();
                           });
  return true;
}

void TextSocket::Close()
{
  this->HasEnded = true;
  Error ignored;
  beast::get_lowest_layer(this->Stream)
      .socket()
      .shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  beast::get_lowest_layer(this->Stream).close();
}

void TextSocket::End(const Error& error)
{
  if (!std::exchange(this->HasEnded, true))
  {
    this->Heard.Ended(error.message());
  }
}
} // namespace palpate
