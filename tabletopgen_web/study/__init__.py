"""User studies (Secs. 4.2 and 8.2): a page that people rate scenes on, and what they answered.

``command`` has the commands, ``collecting`` finds the methods' results, ``page`` makes the HTML
file and its key, ``filling`` fills the built page and reads it back, ``answers`` reads what raters
send, ``measuring`` and ``agreement`` count it.
"""
