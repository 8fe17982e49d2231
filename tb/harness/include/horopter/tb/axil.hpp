// SPDX-License-Identifier: Apache-2.0
// AXI4-Lite master: one access at a time, address and data in any order, answers taken after random waits.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "horopter/tb/axis.hpp"
#include "horopter/tb/random.hpp"
#include "horopter/tb/simulation.hpp"

namespace horopter::tb {

/// `Address` is the C++ type of the address ports in the Verilated model.
template <class Address>
struct AxilPins {
  Address* awaddr;
  std::uint8_t *awvalid, *awready;
  std::uint32_t* wdata;
  std::uint8_t *wstrb, *wvalid, *wready;
  std::uint8_t *bresp, *bvalid, *bready;
  Address* araddr;
  std::uint8_t *arvalid, *arready;
  std::uint32_t* rdata;
  std::uint8_t *rresp, *rvalid, *rready;
};

#define HOROPTER_TB_AXIL(model, prefix)                                                                        \
  {&(model).prefix##_awaddr,  &(model).prefix##_awvalid, &(model).prefix##_awready, &(model).prefix##_wdata,   \
   &(model).prefix##_wstrb,   &(model).prefix##_wvalid,  &(model).prefix##_wready,  &(model).prefix##_bresp,   \
   &(model).prefix##_bvalid,  &(model).prefix##_bready,  &(model).prefix##_araddr,  &(model).prefix##_arvalid, \
   &(model).prefix##_arready, &(model).prefix##_rdata,   &(model).prefix##_rresp,   &(model).prefix##_rvalid,  \
   &(model).prefix##_rready}

template <class Address>
class AxilMaster final : public Endpoint {
 public:
  struct Access {
    bool write = false;
    std::uint32_t address = 0, data = 0;
    std::uint8_t strobe = 0xf;
  };
  struct Answer {
    std::uint32_t data = 0;
    unsigned response = 0;  ///< 0 OKAY, 2 SLVERR, 3 DECERR
  };

  /// `lazy_percent`: how often a channel waits a clock before it moves.
  AxilMaster(AxilPins<Address> pins, std::uint64_t seed, unsigned lazy_percent = 0)
      : pins_{pins}, rng_{seed}, lazy_percent_{lazy_percent} {
    reset();
  }

  void post(const Access& access) { queue_.push_back(access); }
  bool idle() const { return queue_.empty(); }
  /// The answer of the access that ended last.
  const Answer& answer() const { return answer_; }

  void drive() override {
    *pins_.awvalid = *pins_.wvalid = *pins_.bready = *pins_.arvalid = *pins_.rready = 0;
    if (queue_.empty()) return;
    const Access& a = queue_.front();
    const auto move = [&](bool& offering, bool done) {
      if (!offering && !done) offering = !rng_.percent(lazy_percent_);
      return offering;
    };
    if (a.write) {
      *pins_.awvalid = move(address_offered_, address_done_);
      *pins_.awaddr = static_cast<Address>(a.address);
      *pins_.wvalid = move(data_offered_, data_done_);
      *pins_.wdata = a.data;
      *pins_.wstrb = a.strobe;
      *pins_.bready = !rng_.percent(lazy_percent_);
    } else {
      *pins_.arvalid = move(address_offered_, address_done_);
      *pins_.araddr = static_cast<Address>(a.address);
      *pins_.rready = !rng_.percent(lazy_percent_);
    }
  }

  void sample() override {
    if (queue_.empty()) {
      if (*pins_.bvalid || *pins_.rvalid) throw ProtocolError{"AXI4-Lite: an answer that was not asked for"};
      return;
    }
    const bool write = queue_.front().write;
    const auto taken = [](bool& offered, bool& done, bool ready) {
      if (offered && ready) {
        offered = false;
        done = true;
      }
    };
    const bool asked = address_done_ && (!write || data_done_);
    taken(address_offered_, address_done_, write ? *pins_.awready : *pins_.arready);
    if (write) taken(data_offered_, data_done_, *pins_.wready);
    if (write ? *pins_.bvalid : *pins_.rvalid) {
      if (!asked) throw ProtocolError{"AXI4-Lite: an answer before the question"};
      if (write ? *pins_.bready : *pins_.rready) {
        answer_ = write ? Answer{0, *pins_.bresp} : Answer{*pins_.rdata, *pins_.rresp};
        queue_.pop_front();
        address_done_ = data_done_ = false;
      }
    }
  }

  void reset() override {
    queue_.clear();
    *pins_.awvalid = *pins_.wvalid = *pins_.bready = *pins_.arvalid = *pins_.rready = 0;
    address_offered_ = address_done_ = data_offered_ = data_done_ = false;
  }

 private:
  AxilPins<Address> pins_;
  Rng rng_;
  unsigned lazy_percent_;
  std::deque<Access> queue_;
  Answer answer_;
  bool address_offered_ = false, address_done_ = false, data_offered_ = false, data_done_ = false;
};

}  // namespace horopter::tb
