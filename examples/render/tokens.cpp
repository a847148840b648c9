#include "tokens.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>
#include <utility>

namespace render {
namespace {

constexpr std::string_view white_space = " \t\n\v\f\r";
constexpr std::string_view line_ends = "\r\n";

/// Is the first character the last one of a line? Lines end with \n, \r\n or \r.
bool ends_line(std::string_view text) {
    return text.front() == '\n' || (text.front() == '\r' && !text.substr(1).starts_with('\n'));
}

/// Reads a whole token. `std::from_chars` knows no locale, and no plus sign either, which streams accept.
template <class Number>
std::errc parse(std::string_view token, Number& value) {
    if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    return end == token.data() + token.size() ? error : std::errc::invalid_argument;
}

}  // namespace

tokens::tokens(std::string_view text, std::string file, std::size_t line)
    : rest_(text), line_(line), next_line_(line), file_(std::move(file)) {
    skip_byte_order_mark(rest_);
    take();
}

std::string_view tokens::take() {
    const std::string_view taken = next_;
    line_ = next_line_;
    std::size_t line = next_line_;
    comment_ = {};
    while (!rest_.empty() && (rest_.front() == '#' || white_space.find(rest_.front()) != white_space.npos)) {
        if (rest_.front() == '#') {
            comment_ = rest_.substr(0, rest_.find_first_of(white_space));
            rest_.remove_prefix(std::min(rest_.find_first_of(line_ends), rest_.size()));
        } else {
            if (ends_line(rest_)) ++line;
            rest_.remove_prefix(1);
        }
    }
    next_ = rest_.substr(0, rest_.find_first_of(white_space));
    rest_.remove_prefix(next_.size());
    if (!next_.empty()) next_line_ = line;  // the end of the text is told of at the last token, not behind blank lines
    return taken;
}

std::string_view tokens::expect_word(std::string_view what) {
    if (next_.empty()) fail(joined({"a word for ", what}));
    return take();
}

double tokens::expect_number(std::string_view what, const requirement& must_be) {
    double value = 0;
    const std::errc error = parse(next_, value);
    const bool is_number = error != std::errc::invalid_argument && std::isfinite(value);
    const double size = std::fabs(value);
    const bool in_range = error == std::errc() && (size == 0 || (size >= 1e-50 && size <= 1e50));
    if (is_number && !in_range) fail(joined({"0 or a magnitude from 1e-50 to 1e50 for ", what}));
    if (!is_number || !must_be.holds(value)) fail(joined({must_be.words, " for ", what}));
    take();
    return value;
}

std::size_t tokens::expect_count(std::string_view what) {
    const std::size_t count = whole_number(joined({"the count of ", what}));
    const std::size_t most = rest_.size() / 2;  // each needs white space and a token of its own
    if (count > most) fail(joined({"at most ", std::to_string(most), " ", what, " in what is left of the file"}));
    take();
    return count;
}

std::size_t tokens::expect_index(std::string_view what, std::size_t size) {
    const std::size_t index = whole_number(joined({"the index of a ", what}));
    if (size == 0) fail(joined({"no object, since there is no ", what}));
    if (index >= size) fail(joined({"the index of a ", what, ", from 0 to ", std::to_string(size - 1)}));
    take();
    return index;
}

std::size_t tokens::whole_number(std::string_view what) const {
    std::size_t value = 0;
    const std::errc error = parse(next_, value);
    if (error == std::errc::invalid_argument) fail(joined({"a whole number not below 0 for ", what}));
    return error == std::errc() ? value : std::numeric_limits<std::size_t>::max();
}

void tokens::fail(std::string_view expected) const {
    fail_at(next_line_, next_.empty() ? "the end of the file" : joined({"'", printable(next_, 40), "'"}), expected);
}

void tokens::fail(std::string_view found, std::string_view expected) const { fail_at(line_, found, expected); }

void tokens::fail_at(std::size_t line, std::string_view found, std::string_view expected) const {
    throw scene_error(joined({file_, ":", std::to_string(line), ": found ", found, ", expected ", expected}));
}

void skip_byte_order_mark(std::string_view& text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
}

std::string_view take_line(std::string_view& text) {
    const std::string_view line = text.substr(0, text.find_first_of(line_ends));
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with(line_ends) ? 2 : std::min<std::size_t>(text.size(), 1));
    return line;
}

std::string read_text(const std::filesystem::path& file, std::string_view expected) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    const auto fail = [&](std::string_view found) {
        throw scene_error(joined({file.string(), ":1: found ", found, ", expected ", expected}));
    };
    if (!std::filesystem::exists(status)) fail("no such file");
    if (std::filesystem::is_directory(status)) fail("a directory");
    if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status)) fail("a device");
    try {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) fail("a file that may not be opened");
        return {std::istreambuf_iterator<char>(stream), {}};
    } catch (const std::ios_base::failure&) {
        fail("a file that cannot be read to its end");
    }
    return {};
}

std::string joined(std::initializer_list<std::string_view> parts) {
    std::string whole;
    for (const std::string_view part : parts) whole += part;
    return whole;
}

std::string printable(std::string_view text, std::size_t longest) {
    std::string shown;
    for (const char c : text.substr(0, longest)) {
        constexpr std::string_view digits = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        if (c >= ' ' && c <= '~') {
            shown += c;
        } else {
            shown.append("\\x").append(1, digits[byte / 16]).append(1, digits[byte % 16]);
        }
    }
    return text.size() > longest ? shown + "..." : shown;
}

}  // namespace render
