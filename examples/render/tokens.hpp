#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace render {

/// What is wrong with a scene: `what()` is the one line `FILE:LINE: found this, expected that`.
struct scene_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What a number must be, in the words of an error and as a test.
struct requirement {
    std::string_view words;
    bool (*holds)(double);
};

inline constexpr requirement any_number{"a number", [](double) { return true; }};
inline constexpr requirement positive{"a number above 0", [](double x) { return x > 0; }};
inline constexpr requirement not_negative{"a number not below 0", [](double x) { return x >= 0; }};
inline constexpr requirement fraction{"a number from 0 to 1", [](double x) { return x >= 0 && x <= 1; }};

/// The words of a text one after the other, each with its line. White space ends a word, and lines end with \n, \r\n or
/// \r; a word that starts with `#` begins a comment, which reaches to the end of its line. Whatever is not as expected
/// is a `scene_error`. `what` completes "expected a number for ...".
class tokens {
public:
    /// The text must outlive the tokens; `file` is its name in errors, `line` the number of its first line.
    tokens(std::string_view text, std::string file, std::size_t line = 1);

    /// The next token, which stays the next; empty at the end of the text.
    std::string_view peek() const { return next_; }

    /// The word that began the last comment between the token before and the next one; empty if there was none.
    std::string_view comment() const { return comment_; }

    std::string_view expect_word(std::string_view what);

    /// A decimal number, whatever the locale. It is 0 or from 1e-50 to 1e50 in magnitude: so far apart, and no farther,
    /// that products of four lengths neither overflow nor vanish.
    double expect_number(std::string_view what, const requirement& must_be = any_number);

    /// How many of something follow. It is refused where the rest of the text is too short for so many, and may be
    /// trusted so far.
    std::size_t expect_count(std::string_view what);

    /// Which of `size` things is meant, counted from 0.
    std::size_t expect_index(std::string_view what, std::size_t size);

    /// The next token is wrong.
    [[noreturn]] void fail(std::string_view expected) const;

    /// What was read up to here is wrong.
    [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

private:
    std::string_view take();
    std::size_t whole_number(std::string_view what) const;
    [[noreturn]] void fail_at(std::size_t line, std::string_view found, std::string_view expected) const;

    std::string_view comment_, next_, rest_;  // the text from the next token on, cut behind that token
    std::size_t line_, next_line_;
    std::string file_;
};

/// UTF-8 may begin with a mark, which is none of its words.
void skip_byte_order_mark(std::string_view& text);

/// Takes the first line off the text, and what ends it: \n, \r\n or \r.
std::string_view take_line(std::string_view& text);

/// All of a file. Throws `scene_error` if there is none: what was expected is told with it.
std::string read_text(const std::filesystem::path& file, std::string_view expected);

std::string joined(std::initializer_list<std::string_view> parts);

/// The text as part of a message: one line of ASCII, cut where it is longer than `longest` bytes.
std::string printable(std::string_view text, std::size_t longest);

}  // namespace render
