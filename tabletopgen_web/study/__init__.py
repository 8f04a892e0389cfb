"""User studies (Secs. 4.2 and 8.2): a page for raters, and the evaluation of their answers.

``command`` defines the commands, ``collection`` finds the methods' results, ``page`` creates the
HTML file and its key, ``page_data`` fills the built page and reads it back, ``answers`` reads the
raters' answers, and ``statistics`` and ``agreement`` evaluate them.
"""
