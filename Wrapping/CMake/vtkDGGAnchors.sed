# Links to headings of the same page become text, links to headings of other pages lead to the page.
s/\[([^]]*)\]\(#[^)]*\)/\1/g
s/(\.md)#[^)]*\)/\1)/g
