#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace ifedem {

/// How often a fault is tried: `full` times by `make test-reliability`, `brief` times otherwise.
inline int trials(int full, int brief) { return std::getenv("IFEDEM_RELIABILITY_CSV") != nullptr ? full : brief; }

/// Counts how often a fault was survived. The line `fault,tried,survived` goes to the file named by
/// IFEDEM_RELIABILITY_CSV, if any; a fault that was not survived fails the test.
class FaultTally {
public:
    explicit FaultTally(std::string fault) : fault_(std::move(fault)) {}
    ~FaultTally() {
        EXPECT_EQ(survived_, tried_) << fault_;
        if (const char* path = std::getenv("IFEDEM_RELIABILITY_CSV"))
            std::ofstream(path, std::ios::app) << fault_ << ',' << tried_ << ',' << survived_ << '\n';
    }
    FaultTally(const FaultTally&) = delete;
    FaultTally& operator=(const FaultTally&) = delete;

    /// `trouble` is what went wrong, or "".
    void count(const std::string& trouble) {
        ++tried_;
        survived_ += trouble.empty() ? 1 : 0;
        EXPECT_EQ(trouble, "") << fault_ << ", trial " << tried_;
    }
    [[nodiscard]] int tried() const { return tried_; }

private:
    std::string fault_;
    int tried_ = 0, survived_ = 0;
};

}  // namespace ifedem
